"use strict";(()=>{var be=i=>[i[0],i[1],i[2]],Ht=(i,t)=>i[0]*t[0]+i[1]*t[1]+i[2]*t[2],pn=(i,t)=>[i[1]*t[2]-i[2]*t[1],i[2]*t[0]-i[0]*t[2],i[0]*t[1]-i[1]*t[0]],$t=(i,t)=>[i[0]-t[0],i[1]-t[1],i[2]-t[2]],lt=(i,t,e=1)=>[i[0]+e*t[0],i[1]+e*t[1],i[2]+e*t[2]],Dt=(i,t)=>[i[0]*t,i[1]*t,i[2]*t],Li=i=>Math.hypot(i[0],i[1],i[2]);function yd(i,t,e){let[n,s]=[Math.cos(e),Math.sin(e)];return lt(lt(Dt(i,n),pn(t,i),s),t,Ht(t,i)*(1-n))}function Tn(i,t=[0,0,1]){let e=Li(i);return e>0?Dt(i,1/e):t}var X_=3,_d=[["ArrowLeft","ArrowRight","ArrowUp","ArrowDown","Home","End"],["KeyA","KeyD","KeyW","KeyS","KeyQ","KeyE"],["KeyJ","KeyL","KeyI","KeyK","KeyU","KeyO"]],Ml=class{constructor(t,e,n){this.session=t,this.camera=e,this.shortcuts=n,this.held=new Set,this.moving=new Map,addEventListener("keydown",s=>this.press(s)),addEventListener("keyup",s=>this.lift(s.code)),addEventListener("blur",()=>this.releaseAll()),document.addEventListener("visibilitychange",()=>{document.hidden&&this.releaseAll()}),document.addEventListener("click",q_),t.on("connection",()=>this.forget())}press(t){if(Y_(t))return;if(t.ctrlKey||t.metaKey||t.altKey){!t.altKey&&!t.shiftKey&&t.key.toLowerCase()==="z"&&this.shortcuts.undo&&(t.preventDefault(),this.shortcuts.undo());return}let e=_d.findIndex(s=>s.includes(t.code));if(e>=0&&this.anchor(e)!==null&&this.session.can("move")){if(t.preventDefault(),t.repeat||this.held.has(t.code))return;this.held.add(t.code),this.sendHand(e);return}let n=this.shortcuts[t.key.toLowerCase()];n&&(t.key===" "&&K_(t.target)||(t.key!=="Escape"&&t.preventDefault(),(!t.repeat||t.key===".")&&n()))}lift(t){this.held.delete(t)&&this.sendHand(_d.findIndex(e=>e.includes(t)))}releaseAll(){this.held.clear();for(let t of[...this.moving.keys()])this.sendHand(t)}forget(){this.held.clear(),this.moving.clear()}anchor(t){let e=this.session.layout?.variants[0].anchors??[],n=this.session.frame?.parts[0];return e.filter((r,o)=>!n||n.anchors[10*o+9]>.5)[t]?.name??null}sendHand(t){let e=_d[t].map(p=>this.held.has(p)?1:0),n=this.moving.get(t)??this.anchor(t);if(n===null)return;let[s,r,o,a,l,c]=e,{camera:h}=this,u=Dt(h.first,r-s);u=lt(u,h.up,o-a),u=lt(u,h.second,l-c);let d=Li(u),f=d>0?Dt(u,X_/d):[0,0,0];d>0?this.moving.set(t,n):this.moving.delete(t),this.session.send({type:"move",anchor:n,velocity:f})}};function q_(i){let{target:t}=i;if(i.detail===0||!(t instanceof Element))return;t instanceof HTMLInputElement&&["range","checkbox"].includes(t.type)?t.blur():t.closest("button")?.blur()}function Y_({target:i,code:t}){return i instanceof HTMLElement?i instanceof HTMLInputElement?i.type==="range"?/^(Arrow|Page|Home|End)/.test(t):!["checkbox","radio","button"].includes(i.type):i.isContentEditable||["SELECT","TEXTAREA"].includes(i.tagName):!1}function K_(i){return i instanceof HTMLElement&&i.closest("button, summary, [role=menuitem]")!==null}var Bs=i=>new DataView(i).getUint32(4,!0),km=i=>new DataView(i).getUint32(8,!0);function ur(i,t){let e=new DataView(i);if(e.byteLength<48||e.getUint32(0,!0)!==1179670354)throw new Error("not a frame");if(e.getUint32(4,!0)!==t.layout)throw new Error("a frame of another layout");if(i.byteLength<t.bytes)throw new Error("a frame cut short");return{layout:t.layout,number:e.getUint32(8,!0),flags:e.getUint32(12,!0),time:e.getFloat64(16,!0),steps:e.getFloat64(24,!0),realtime:e.getFloat32(32,!0),speed:e.getFloat32(36,!0),load:e.getFloat32(40,!0),parts:t.variants.map((n,s)=>Z_(i,t,n,s))}}function Bm(i){i.parts[0]?.scalars.buffer?.transfer?.(0)}function Z_(i,t,e,n){let{offsets:s,nodes:r,anchors:o}=e,a=t.variants[n+1]?.offsets.scalars??t.bytes;return{scalars:new Float32Array(i,s.scalars,t.scalars.length),positions:new Float32Array(i,s.positions,3*r),tension:new Uint16Array(i,s.tension,r),speed:new Uint16Array(i,s.speed,r),seen:{leastTension:new Uint16Array(i,s.least_tension,r),greatestTension:new Uint16Array(i,s.greatest_tension,r),greatestSpeed:new Uint16Array(i,s.greatest_speed,r),leastHeight:new Uint16Array(i,s.least_height,r),greatestHeight:new Uint16Array(i,s.greatest_height,r),greatestForce:new Float32Array(i,s.greatest_force,o.length)},anchors:new Float32Array(i,s.anchors,10*o.length),contact:to(i,s,"contact"),ropeContacts:to(i,s,"rope_contacts"),wraps:to(i,s,"wraps"),frictionWork:to(i,s,"friction_work"),grabs:new Float32Array(i,s.grabs,8*Math.floor((a-s.grabs)/32))}}var Um=["contact","rope_contacts","wraps","friction_work"];function to(i,t,e){let n=t[e];if(n===void 0)return new Float32Array(0);let r=Um.slice(Um.indexOf(e)+1).map(o=>t[o]).find(o=>o!==void 0)??t.grabs;return new Float32Array(i,n,(r-n)/4)}var zm=({contact:i,grabs:t})=>i!==void 0&&i<t;function Be(i,t,e){let n=i.scalars.indexOf(e);return n<0?NaN:t.scalars[n]}function eo(i,t,e,n,s){let r=n===null?0:Be(i,t,n);return r+e/65535*(Be(i,t,s)-r)}var ua=class{constructor(){this.low=0,this.high=1,this.fresh=!0,this.unknown=!0,this.since=[0,0]}follow(t,e,n){if(!Number.isFinite(t)||!Number.isFinite(e))return;let s=t<-.01*e&&t<-1e-9?t:0,r=Math.max(e,s+1e-9);if(this.unknown=!1,this.fresh){[this.low,this.high,this.fresh]=[s,r,!1];return}let[o,a]=this.since;this.since=[s<=this.low?0:o+n,r>=this.high?0:a+n];let[l,c]=this.since.map(h=>1-Math.exp(-n/(h>2?.5:4)));this.high=r>this.high?r:this.high+c*(Math.max(r,1e-9)-this.high),this.low=s<this.low?s:this.low+l*(s-this.low)}beyond(t,e){let n=.01*(this.high-this.low);return[t<this.low-n,e>this.high+n]}},wd=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"]],J_=new Set(["N","J","W","s","Hz","N/m","m","m/s","N s/m"]),wi=i=>i==="1"?"":i.replace(/\^2/g,"²").replace(/\^3/g,"³");function ce(i,t=""){if(i==null||Number.isNaN(i))return"–";if(!Number.isFinite(i))return i>0?"∞":"−∞";let e=t&&t!=="1"?` ${wi(t)}`:"",n=Math.abs(i);if(n<1e-25)return`0${e}`;if(J_.has(t)&&(n>=1e4||n<.1)&&n>=1e-9){let s=t==="m"||t==="m/s"?1:1e10,[r,o]=wd.find(([a])=>n>=a*.9995&&a<=s)??wd[6];return`${Te(i/r)} ${o}${t}`}return`${Te(i)}${e}`}function bd(i,t,e=!1){let n=Math.max(0,...i.map(Math.abs)),[,s]=ce(n,t).split(" "),r=wd.find(([,p])=>p&&p+t===s),[o,a]=e||!r?[1,""]:r;if(!i.length||n/o<.001||n/o>=1e7)return i.map(p=>ce(p,t));let l=i.map(p=>p/o),c=l.slice(1).map((p,x)=>p-l[x]),h=.01*Math.min(n/o,...c),u=p=>l.every(x=>Math.abs(Number(x.toFixed(p))-x)<=h),d=0;for(;d<12&&!u(d);)d+=1;let f=t&&t!=="1"?` ${a}${wi(t)}`:"";return l.map(p=>`${Number(p.toFixed(d))+0}${f}`.replace("-","−"))}function Te(i){let t=Math.abs(i);if(t>=1e5||t<.001){if(i===0)return"0";let[n,s]=i.toExponential(2).split("e");return`${Number(n)}e${Number(s)}`.replaceAll("-","−")}let e=Math.max(0,2-Math.floor(Math.log10(t)));return String(Number(i.toFixed(Math.min(6,e)))).replace("-","−")}function Hm(i){let t=10**Math.floor(Math.log10(i)),e=i/t;return t*(e<1.5?1:e<3.5?2:e<7.5?5:10)}var j_=Math.cos(.6);function Gm(i,t){let e=i.length/3;if(!t.length||!t.every(f=>Number.isInteger(f)&&f>=0&&f<e))return null;let n=Array.from({length:e},(f,p)=>dr(i,p)),s=n.reduce((f,p)=>Vm(f,p)),r=n.reduce((f,p)=>Dt(Vm(Dt(f,-1),Dt(p,-1)),-1)),o=Dt(lt(s,r),.5),a=Array.from({length:t.length/3},(f,p)=>t.slice(3*p,3*p+3).map(x=>$t(n[x],o))),l=a.map(([f,p,x])=>Tn(pn($t(p,f),$t(x,f)))),c=n.map(()=>[]);t.forEach((f,p)=>c[f].push(Math.floor(p/3)));let h=new Float32Array(3*t.length),u=new Float32Array(3*t.length);t.forEach((f,p)=>{let x=l[Math.floor(p/3)],g=c[f].map(m=>l[m]).filter(m=>Ht(m,x)>j_);h.set(a[Math.floor(p/3)][p%3],3*p),u.set(Tn(g.reduce((m,v)=>lt(m,v))),3*p)});let d=Dt($t(r,s),.5);return{middle:o,half:d,reach:Math.hypot(...d),places:h,normals:u}}function Wm({places:i,reach:t},e,n){let s=Dt(n,-Ht(e,n));if(Math.hypot(...lt(e,s))>t)return 1/0;let r=1/0;for(let o=0;o<i.length/3;o+=3){let a=dr(i,o),[l,c]=[$t(dr(i,o+1),a),$t(dr(i,o+2),a)],h=pn(n,c),u=Ht(l,h);if(u===0)continue;let d=$t(e,a),f=Ht(d,h)/u;if(!(f>=0&&f<=1))continue;let p=pn(d,l),x=Ht(n,p)/u,g=Ht(c,p)/u;x>=0&&f+x<=1&&g>=0&&g<r&&(r=g)}return r}var dr=(i,t)=>[i[3*t],i[3*t+1],i[3*t+2]],Vm=(i,t)=>[Math.min(i[0],t[0]),Math.min(i[1],t[1]),Math.min(i[2],t[2])];var Sd=["plane","sphere","cylinder","capsule","box","torus","half-pipe","mesh"],Ed=200,Q_=.04,$m=1e9,Md=1e30,Sl=.35;function Xm(i,t){return t.filter((n,s)=>t.findIndex(r=>tw(r,n))===s).flatMap(n=>i.map(s=>ew(s,n))).filter(n=>n!==null).slice(0,Ed)}var tw=(i,t)=>i.every((e,n)=>e===t[n]);function ew(i,t){let{name:e,center:n,axis:s,axle:r,hub:o,first:a,size:l,spin:c,turns:h,motion:u,wheel:d}=i,f=i.kind==="sdf"?"mesh":i.kind,p=Sd.indexOf(f),{vertices:x,faces:g}=i,m=x&&g?Gm(x,g):null,v=m?.middle??[0,0,0];if(f==="mesh"&&!m)return null;let M=f==="cylinder"&&l[1]===null?Md:l[1]??NaN,w=m?[...m.half,0]:[l[0]??NaN,M,l[2]??NaN,l[3]??NaN],R=N=>Math.abs(N)<$m,T=[...n,...s,...w.map(N=>N===Md?0:N)];if(p<0||!T.every(R)||!(Math.hypot(...s)>0))return null;let y=c&&R(c[0])&&R(c[1]),A=Tn(s),U=Math.abs(A[2])<.9?[0,0,1]:[1,0,0];return{name:e,kind:f,number:p,center:lt(lt(n,t),v),axis:A,size:w,zero:a?Qi(a):Tn($t(U,Dt(A,Ht(U,A)))),axle:Tn(r??s),hub:o?$t(Qi(o),Qi(n)):[0,0,0],sweeps:r!==void 0,middle:v,reach:nw(f,w),spin:y?[c[0],c[1],c[2]??1/0]:null,turns:h??null,wheel:d??null,motion:u?{...u,origin:Qi(n)}:null,surface:m}}var Td=i=>i==="box"||i==="mesh",zs=({axis:i,zero:t})=>[t,pn(i,t),i];function nw(i,[t,e,n,s]){return i==="plane"||i==="half-pipe"||e===Md?1/0:i==="sphere"?t:i==="cylinder"?Math.hypot(t,e):Td(i)?Math.hypot(t,e,n)+s:t+e}var Ad=({kind:i,size:t})=>i==="cylinder"?Q_*Math.min(t[0],t[1]):0;function Rd({spin:i,turns:t,wheel:e},n,s=[]){if(e!==null)return s[e]||0;if(t)return Km(t,n)[0];if(!i)return 0;let[r,o,a]=i;return r*Math.max(0,Math.min(n,a)-o)}var El=i=>!i.sweeps&&!!(i.spin||i.turns||i.wheel!==null),qm=i=>!!(i.motion||i.sweeps&&(i.spin||i.turns||i.wheel!==null));function Ym(i,t,e=[]){let n=i.sweeps?iw(i,Rd(i,t,e)):i;if(!i.motion)return n;let s=$t(sw(i.motion,t),i.motion.origin);return s.every(r=>Math.abs(r)<$m)?{...n,center:lt(n.center,s)}:n}function iw(i,t){if(!t||!Number.isFinite(t))return i;let{axle:e,axis:n,zero:s,size:r,center:o}=i,a=u=>yd(u,e,t),l=$t(o,i.middle),c=lt(l,i.hub),h=lt(c,a($t(o,c)));return{...i,axis:a(n),zero:a(s),size:i.kind==="half-pipe"?[r[0],...a(Qi(r.slice(1)))]:r,middle:$t(h,l),center:h}}function sw({kind:i,params:t,table:e},n){let[s,r,o]=[Qi(t),Qi(t.slice(3)),Qi(t.slice(6))];if(i==="table")return Km(e,n);if(i==="velocity"){let l=Number(t[6]),c=Math.min(Math.max(n-l,0),(t[7]??1/0)-l);return lt(s,Dt(r,c))}if(i==="shake"){let l=Number(t[7]),c=Math.sin(2*Math.PI*Number(t[6])*n+l)-Math.sin(l);return lt(s,Dt(r,c))}if(i!=="orbit")return s;let a=2*Math.PI*Number(t[9])*n;return lt(r,yd($t(s,r),o,a))}function Km(i,t){let e=0,n=i.length-1;for(t>=i[n][0]&&(e=n);n-e>1;){let a=e+n>>1;i[a][0]<=t?e=a:n=a}let s=i[e],r=e===i.length-1?0:Math.max(t-s[0],0),o=a=>s[a]+r*(s[a+1]+r*(s[a+2]+r*s[a+3]));return[o(1),o(5),o(9)]}var Qi=([i,t,e])=>[Number(i),Number(t),Number(e)];function rw({axis:i,size:t},e){let n=$t(e,Dt(i,Ht(e,i))),s=Qi(t.slice(1)),r=Ht(n,s)>0;return t[0]-(r?Math.abs(Ht(n,pn(s,i))):Math.hypot(...n))}function Zm(i,t){let{kind:e,center:n,axis:s,size:r}=i,o=$t(t,n),a=Ht(o,s);if(e==="plane")return a;if(e==="half-pipe")return rw(i,o);if(e==="sphere")return Math.hypot(...o)-r[0];if(Td(e)){let h=zs(i).map((d,f)=>Math.abs(Ht(o,d))-r[f]);return Math.hypot(...h.map(d=>Math.max(d,0)))+Math.min(Math.max(...h),0)-r[3]}let l=Math.hypot(...$t(o,Dt(s,a)))-r[0];if(e==="torus")return Math.hypot(l,a)-r[1];let c=Math.abs(a)-r[1];return e==="capsule"?c>0?Math.hypot(l+r[0],c)-r[0]:l:Math.hypot(Math.max(l,0),Math.max(c,0))+Math.min(Math.max(l,c),0)}function Cd(i,t){let{kind:e,axis:n,size:s}=i,r=Math.abs(Ht(n,t)),o=Math.sqrt(Math.max(0,1-r*r));return e==="sphere"?s[0]:Td(e)?zs(i).reduce((a,l,c)=>a+Math.abs(Ht(t,l))*s[c],s[3]):e==="torus"?s[0]*o+s[1]:s[1]*r+s[0]*(e==="cylinder"?o:1)}function Tl(i){let t=zs(i),e=t.map(n=>Cd(i,n));return Array.from({length:8},(n,s)=>t.reduce((r,o,a)=>lt(r,o,s>>a&1?e[a]:-e[a]),i.center))}function Al(i,t,e){let n=$t(i.center,t);if(i.surface){let o=zs(i),a=c=>Qi(o.map(h=>Ht(h,c))),l=Wm(i.surface,a(Dt(n,-1)),a(e));return Number.isFinite(l)?l:null}let s=Ht(n,e);if(Math.hypot(...$t(n,Dt(e,s)))>i.reach)return null;let r=Math.max(0,s-i.reach);for(let o=0;o<80&&r<s+i.reach;o++){let a=Zm(i,lt(t,e,r));if(a<.001*i.reach)return r;r+=a}return null}function fr(i,t,e,n){if(i.kind==="half-pipe"||i.kind==="mesh")return!1;let s=$t(e,t),r=Math.hypot(...s),o=Dt(s,1/Math.max(r,1e-12)),a=Number.isFinite(i.reach)?Math.max(0,Math.hypot(...$t(i.center,t))-i.reach):0;for(let l=0;l<60&&a<r;l++){let c=Zm(i,lt(t,o,a))+n;if(c<=0)return!0;a+=Math.max(c,1e-4*r)}return!1}var ow=1e-4;function Jm(i,t,e){let n=i.filter(({time:a})=>t-a<=e);if(n.length<2)return[0,0,0];let[s,r]=[n[0],n[n.length-1]],o=(t-s.time)/1e3;return o>0?Dt($t(r.place,s.place),1/o):[0,0,0]}function da(i,t){if(!t?.playing)return 1;let e=i&&t.slow&&i.realtime>0?i.realtime:t.speed;return Math.max(ow,Math.min(e,t.speed))}var aw=16,lw=.02,jm=Math.PI/12,cw=.5,hw=400;function Id(i,t,e){let{camera:n,session:s}=i;if(!s.can("obstacle"))return null;let r=n.ray(t,e),o=Math.hypot(...r),a=Dt(r,1/o),l=1/0,c=null;for(let h of i.solids.all){let d=Number.isFinite(h.reach)&&uw(i,h.name)?Al(h,n.eye,a):null;if(d===null||d>=l)continue;l=d;let f=lt(n.eye,a,d);c={kind:"obstacle",variant:0,obstacle:h.name,node:-1,segment:-1,place:f}}return c}var no=(i,t)=>(i.session.layout?.obstacles??[]).some(e=>e.name===t&&e.turnable),uw=(i,t)=>(i.session.layout?.obstacles??[]).some(e=>e.name===t&&e.movable),fa=class{constructor(t,e,n){this.viewport=t,this.hit=e,this.way="body",this.place=e.place,this.turning=n&&no(t,e.obstacle),this.start=t.solids.base(e.obstacle),this.angle=t.solids.angleOf(e.obstacle),this.begun=!1,this.sent=-1/0,this.pending=0,this.limit=null,this.last=null}moveTo(t,e){let{viewport:n,hit:s,last:r}=this;this.turning?(r&&(this.angle+=this.turnBetween(r,{x:t,y:e})),this.last={x:t,y:e}):this.place=n.camera.onPlane(t,e,s.place,n.axis);let o=this.sent+aw-performance.now();o<=0?this.sendTarget():this.pending||=window.setTimeout(()=>this.sendTarget(),o)}turnBetween(t,e){let{camera:n,solids:s}=this.viewport,r=s.named(this.hit.obstacle);if(!r)return 0;let[o,a,l]=n.project(...$t(r.center,r.middle)),c=Ht(r.axle,n.toward);if(Math.abs(c)>cw){let[f,p]=[t,e].map(({x:g,y:m})=>Math.atan2(a-m,g-o)),x=p-f-2*Math.PI*Math.round((p-f)/(2*Math.PI));return Math.sign(c)*x}let h=Tn(pn(r.axle,n.toward)),u=lt(Dt(n.right,e.x-t.x),n.top,t.y-e.y),d=l/n.focal;return Ht(u,h)*d/Math.max(r.surface?r.reach:r.size[0],1e-9)}sendTarget(){if(clearTimeout(this.pending),this.pending=0,this.over||!this.start)return;this.sent=performance.now();let{session:t}=this.viewport,e=$t(this.place,this.hit.place),n=this.turning?null:lt(this.start,e);Cl(this.viewport,this.hit.obstacle,n,this.turning?this.angle:null,!this.begun),this.begun=this.begun||t.can("obstacle")}release(){this.pending&&this.sendTarget(),this.over=!0}over=!1;get ring(){return this.place}};function Cl({session:i},t,e,n,s){let r=da(i.frame,i.status);i.send({type:"obstacle",obstacle:t,target:e,angle:n,pace:r,begin:s})}var Rl=class{constructor(t){this.viewport=t,this.goal=null}press(t,e){let{viewport:n}=this,{camera:s,solids:r,session:o}=n,a=lw*(o.layout?.view.radius??1),l={ArrowLeft:Dt(s.first,-a),ArrowRight:Dt(s.first,a),ArrowUp:Dt(s.up,a),ArrowDown:Dt(s.up,-a),Home:Dt(s.second,a),End:Dt(s.second,-a)},c={PageUp:jm,PageDown:-jm}[e],h=l[e],u=r.base(t);if(!h&&c===void 0||!u||!o.can("obstacle"))return!1;let d=performance.now(),f=this.goal?.name===t&&d-this.goal.time<hw?this.goal:null,p=f??{name:t,place:u,angle:r.angleOf(t),time:d};if(h)p.place=lt(p.place,h);else if(no(n,t))p.angle+=c??0;else return!0;return p.time=d,this.goal=p,Cl(n,t,h?p.place:null,h?null:p.angle,!f),!0}};var dw=9;function pr(i,t,e,n){let s=pw(i,t,e,n*1.3)??mw(i,t,e,n);return s&&{...s,...fw(i,s,t,e,n)}}function fw(i,t,e,n,s){let r=i.session.layout?.variants[t.variant].joints??[];for(let o of[t.node,t.segment,t.segment+1]){let a=r.find(({nodes:u})=>u.includes(o));if(!a)continue;let{x:l,y:c,depth:h}=i.screenOf(o,t.variant);if(h>0&&Math.hypot(l-e,c-n)<s)return t.kind==="node"?{joint:a.name,node:o}:{joint:a.name}}return{}}function Qm({camera:i,solids:t},e,n,s,r=0){let o=Math.max(r,s*n/i.focal),a=$t(e,i.eye),l=Li(a);return t.all.some(c=>c.surface?(Al(c,i.eye,Dt(a,1/l))??1/0)<l-o:fr(c,i.eye,e,o))}function pw(i,t,e,n){let{layout:s,frame:r}=i.session;if(!s||!r)return null;let o=null,a=n,l=0;return s.variants.forEach((c,h)=>{c.anchors.forEach((u,d)=>{let f=be(i.anchors.shown.subarray(l,l+3));if(l+=3,r.parts[h].anchors[10*d+9]<.5)return;let[p,x,g]=i.camera.project(...f),m=Math.hypot(p-t,x-e);if(g<=0||m>=a||Qm(i,f,g,dw))return;a=m;let v=Math.min(u.index,c.nodes-2);o={kind:"anchor",variant:h,anchor:u.name,node:u.index,segment:v,place:f}})}),o}function mw(i,t,e,n){let{layout:s}=i.session;if(!s)return null;let{shown:r}=i.nodes,o=i.leastWidth/2,a=null,[l,c]=[n,1/0];return s.variants.forEach((h,u)=>{for(let d of h.ropes){let f=i.gaps.now[u]??[],[p,x,g]=[0,0,0];for(let m=d.first;m<d.first+d.nodes;m++){let v=4*(i.starts[u]+m),[M,w,R]=i.camera.project(r[v],r[v+1],r[v+2]);if(m>d.first&&g>0&&R>0&&!f.includes(m-1)){let[T,y]=gw(t,e,p,x,M,w),A=g+y*(R-g),U=Math.max(o,d.diameter/2*(i.camera.focal/A)),N=Math.max(T-U,0)+o;if(N<n&&(N<l||N===l&&A<c)){let[P,G]=[be(r.subarray(v-4,v-1)),be(r.subarray(v,v+3))],W=lt(Dt(P,1-y),Dt(G,y));if(!Qm(i,W,A,o,d.diameter/2)){[l,c]=[N,A];let[D,V]=y>.5?[m,G]:[m-1,P];a={kind:"node",variant:u,rope:d.name,node:D,segment:m-1,place:V}}}}[p,x,g]=[M,w,R]}}}),a}function mr(i,t){if(t.kind==="obstacle")return i.solids.named(t.obstacle)?.center??null;let e=i.session.layout?.variants[t.variant];if(!e||t.node>=e.nodes)return null;let n=4*(i.starts[t.variant]+t.node);return be(i.nodes.shown.subarray(n,n+3))}function gw(i,t,e,n,s,r){let[o,a]=[s-e,r-n],l=o*o+a*a,c=l>0?Math.min(1,Math.max(0,((i-e)*o+(t-n)*a)/l)):0;return[Math.hypot(i-e-c*o,t-n-c*a),c]}var xw=8,tg=40,vw=1e-9,Il=(i,t)=>ce(Math.abs(i)<vw?0:i,t);function yw(i,t){let[e]=i.variants,{anchors:n}=t.parts[0],s=new Map(e.anchors.filter((c,h)=>n[10*h+9]>.5).map(c=>[c.index,c.name])),r=e.loads.map(({index:c})=>c),o=e.joints??[],a=o.map(({nodes:c})=>c[0]),l=e.ropes.length>4?0:xw;return e.ropes.flatMap(c=>{let h=c.nodes-1,u=Array.from({length:l+2},(p,x)=>Math.round(x*h/(l+1))).map(p=>c.first+p),d=[...s.keys(),...r,...a].filter(p=>p>=c.first&&p<=c.first+h);return[...new Set([...u,...d])].sort((p,x)=>p-x).map(p=>{let x=Math.min(p,c.first+h-1),g={variant:0,node:p,segment:x,place:[0,0,0]},m=o.find(({nodes:M})=>M.includes(p))?.name,v=s.get(p);return v===void 0?{kind:"node",rope:c.name,joint:m,...g}:{kind:"anchor",anchor:v,joint:m,...g}})}).slice(0,tg)}function _w(i,t,e){let[n]=i.variants,[s]=t.parts;if(e.kind==="anchor"){let u=n.anchors.findIndex(({name:f})=>f===e.anchor),d=Math.hypot(...s.anchors.subarray(10*u+6,10*u+9));return`Anchor ${e.anchor}, force ${Il(d,"N")}`}let r=n.ropes.find(({name:u})=>u===e.rope),o=r?`Node ${e.node-r.zero} of ${r.name}`:`Node ${e.node}`,a=n.loads.filter(({index:u})=>u===e.node).reduce((u,d)=>u+d.mass,0),l=eo(i,s,s.tension[e.segment],"tension_low","tension_high"),c=a>0?`, load ${ce(a,"kg")}`:"",h=e.joint===void 0?"":`, tied by joint ${e.joint}`;return`${o}, tension ${Il(l,"N")}${c}${h}`}function ww(i,t,e){let[n]=t.parts,s=i.variants[0].anchors.filter((a,l)=>n.anchors[10*l+9]>.5).length,r=s===1?"one anchor holds":`${s} anchors hold`,o=Il(Be(i,n,"tension_high"),"N");return`${i.scene.name}: ${e} at ${ce(t.time,"s")}, ${r}, greatest tension ${o}.`}var Pl=class{constructor(t,e,n,s){this.viewport=t,this.canvas=e,this.voice=n,this.menu=s,this.at=-1,this.back=-1,this.state="",this.bodyKeys=new Rl(t),e.setAttribute("role","slider"),e.setAttribute("aria-label","Places on the ropes"),e.setAttribute("aria-valuemin","1"),e.addEventListener("keydown",r=>this.press(r)),e.addEventListener("blur",()=>this.go(-1)),e.addEventListener("focus",()=>{this.go(this.back),this.back=-1}),e.addEventListener("pointerdown",()=>this.go(this.back=-1));for(let r of["status","broken","frame"])t.session.on(r,()=>this.tell())}get stops(){let{layout:t,frame:e}=this.viewport.session;return t&&e?[...yw(t,e),...this.bodies(t)]:[]}bodies({obstacles:t=[]}){if(!this.viewport.session.can("obstacle"))return[];let e={variant:0,node:-1,segment:-1,place:[0,0,0]};return t.filter(({movable:n,turnable:s})=>n||s).slice(0,tg).map(({name:n})=>({kind:"obstacle",obstacle:n,...e}))}words(t){let{layout:e,frame:n}=this.viewport.session;if(!e||!n)return"";if(t.kind!=="obstacle")return _w(e,n,t);let s=(this.viewport.solids.base(t.obstacle)??[]).map(o=>Il(o,"m")),r=no(this.viewport,t.obstacle)?", Page Up and Page Down turn it":"";return`Obstacle ${t.obstacle}, at ${s.join(", ")}: arrow keys, Home and End move it${r}`}press(t){let{stops:e}=this;if(t.key==="Tab"){let n=this.at<0&&t.shiftKey?-1:this.at+(t.shiftKey?-1:1);if(n<0||n>=e.length)return this.go(-1);t.preventDefault(),this.go(n)}else if(t.key==="Enter"&&e[this.at]){t.preventDefault();let n=mr(this.viewport,e[this.at]);if(!n)return;let[s,r]=this.viewport.camera.project(...n);this.back=this.at,this.menu(e[this.at],s,r)}else if(e[this.at]?.kind==="obstacle"){let{obstacle:n}=e[this.at];if(!this.bodyKeys.press(n,t.code))return;t.preventDefault(),t.stopPropagation()}}go(t){let{viewport:e,canvas:n}=this,{stops:s}=this,r=s[t]??null;this.at=r?t:-1,e.marks.chosen!==r&&(e.marks.dirty=!0),e.marks.chosen=r,n.setAttribute("aria-valuemax",String(s.length)),n.setAttribute("aria-valuenow",String(this.at+1));let o=r?this.words(r):"None: Tab goes to the next";n.setAttribute("aria-valuetext",o)}tell(){let{layout:t,frame:e,status:n,broken:s}=this.viewport.session;if(!t||!e)return;let r=s?"broken":n?.playing?"playing":"paused",o=n?.playing?"":`${t.layout} ${e.time}`,a=`${t.scene.name} ${r} ${o}`;a!==this.state&&(this.state=a,this.voice.textContent=ww(t,e,r),this.at>=0&&this.go(this.at))}};function ts(i,{variant:t,node:e,segment:n}){let s=i?.variants[t]?.ropes.find(({first:l,nodes:c})=>e>=l&&e<l+c),r=i?.variants[0].ropes.find(({name:l})=>l===s?.name);if(!s||!r)return{node:e,segment:n};let o=r.segments/Math.max(s.segments,1),a=Math.floor((n-s.zero+.5)*o);return{node:r.zero+Math.round((e-s.zero)*o),segment:r.zero+Math.min(Math.max(a,0),r.segments-1)}}function eg(i,t,e){if(t.nodes===e.nodes)return i;let n={variants:[e,t]},s=[...i].map(r=>ts(n,{variant:1,node:r,segment:r}).node);return new Set(s.filter(r=>r<e.nodes))}var bw=8,Mw=80,Sw=40,Ew=.05,Tw=.05,pa=class{constructor(t,e,n){this.viewport=t,this.hit=e,this.way=n,this.node=ts(t.session.layout,e).node,this.place=e.place,this.sent=-1/0,this.pending=0,this.trace=[],this.limit=null}moveTo(t,e,n){let{viewport:s,hit:r}=this;if(this.place=s.camera.onPlane(t,e,r.place,s.axis),this.way==="kick"){let a=`${Te(Li(this.velocity()))} m/s`;s.marks.kick={from:r.place,to:this.place,text:a},s.marks.dirty=!0;return}if(this.way==="tie"){s.marks.line={hit:r,to:this.place},s.marks.dirty=!0;return}s.marks.held.add(this),s.marks.dirty=!0,this.trace.push({time:n,place:this.place}),this.trace.length>Sw&&this.trace.shift();let o=this.sent+bw-performance.now();o<=0?this.sendTarget():this.pending||=window.setTimeout(()=>this.sendTarget(),o)}sendTarget(){if(clearTimeout(this.pending),this.pending=0,this.over)return;this.sent=performance.now();let t=$t(this.place,this.viewport.shifts[this.hit.variant]),{hit:e,limit:n}=this,{session:s}=this.viewport,r=da(s.frame,s.status);e.kind==="anchor"?s.send({type:"drag",anchor:e.anchor,target:t,pace:r}):s.send({type:"grab",node:this.node,target:t,pace:r,limit:n})}velocity(){let{camera:t}=this.viewport,e=t.pose.distance/t.focal;return Dt($t(this.place,this.hit.place),Tw/e)}release(t,e){let{session:n,marks:s}=this.viewport;if(s.held.delete(this),s.dirty=!0,this.way==="tie")s.line=null;else if(this.way==="kick"){s.kick=null;let r=this.velocity();Li(r)>.05&&n.tell({type:"kick",node:this.node,velocity:r})}else if(this.hit.kind==="anchor")this.sendTarget(),n.send({type:"drop",anchor:this.hit.anchor});else if(t)this.sendTarget();else{let r=da(n.frame,n.status),o=n.status?.playing?Dt(Jm(this.trace,e,Mw),1/r):[0,0,0],a=Li(o)>Ew?o:null;n.send({type:"let_go",node:this.node,velocity:a})}this.over=!0}over=!1};var ng=18,Aw=30,Rw=2.2,Cw=5,Iw=550,Pw=350,Ll=class{constructor(t,e,n){this.viewport=t,this.element=e,this.actions=n,this.tool="hand",this.keep=!1,this.limit=null,this.down=new Map,this.hands=new Map,this.near=!1,this.resting=null,this.hit=null,this.body=null,this.start=null,this.moved=!1,this.lastClick=0,this.longPress=0,this.menuOpened=!1,this.hovering=!1,e.addEventListener("pointerdown",r=>this.press(r)),e.addEventListener("pointermove",r=>this.move(r)),e.addEventListener("pointerrawupdate",r=>this.drag(r)),e.addEventListener("pointerup",r=>this.lift(r)),e.addEventListener("pointercancel",r=>this.lift(r)),e.addEventListener("pointerleave",()=>{this.resting=null,this.hover(null)}),t.beforeDraw.push(()=>this.look());let s="";t.session.on("layout",({variants:r})=>{let o=JSON.stringify(r.map(a=>a.ropes.map(({first:l,nodes:c})=>[l,c])));o!==s&&this.hands.size>0&&this.leaveOff(),s=o}),e.addEventListener("wheel",r=>this.wheel(r),{passive:!1}),e.addEventListener("contextmenu",r=>r.preventDefault())}at(t){let e=this.element.getBoundingClientRect();return{x:t.clientX-e.left,y:t.clientY-e.top}}reach(t){return t.pointerType==="mouse"?ng:Aw}press(t){this.element.setPointerCapture(t.pointerId);let{x:e,y:n}=this.at(t);if(this.down.set(t.pointerId,{x:e,y:n}),this.viewport.flight=null,this.down.size>1){clearTimeout(this.longPress);let s=this.hands.size>0?pr(this.viewport,e,n,this.reach(t)):null;if(s&&this.hold(t.pointerId,s))return;this.dropHands(!1),this.moved=!0;return}this.start={x:e,y:n,button:t.button,shift:t.shiftKey},this.moved=this.menuOpened=!1,this.hit=pr(this.viewport,e,n,this.reach(t)),this.body=this.hit?null:Id(this.viewport,e,n),this.near=!this.hit&&!this.body&&pr(this.viewport,e,n,Rw*this.reach(t))!==null,t.button===0&&this.hit&&!(t.ctrlKey||t.metaKey)?this.hold(t.pointerId,this.hit):t.button===0&&this.body&&this.tool==="hand"&&this.hands.set(t.pointerId,new fa(this.viewport,this.body,t.shiftKey)),t.pointerType!=="mouse"&&(this.longPress=window.setTimeout(()=>this.openMenu(e,n),Iw))}hold(t,e){let{tool:n}=this;if(n!=="hand"&&n!=="kick"&&n!=="tie")return!1;let s=n!=="hand"?n:e.kind==="anchor"?"drag":"grab";if(!this.viewport.session.can(s))return!1;let r=new pa(this.viewport,e,s);return r.limit=this.limit,this.hands.set(t,r),!0}move(t){let{x:e,y:n}=this.at(t),s=this.down.get(t.pointerId);if(!s){this.resting=t.pointerType==="mouse"?{x:e,y:n}:null,this.look();return}if(this.down.size===2&&this.hands.size<2){this.pinch(t.pointerId,e,n);return}let{start:r}=this;if(!r||!this.moved&&Math.hypot(e-r.x,n-r.y)<Cw)return;this.moved=!0,clearTimeout(this.longPress);let[o,a]=[e-s.x,n-s.y];if(this.down.set(t.pointerId,{x:e,y:n}),this.menuOpened)return;let l=this.hands.get(t.pointerId);if(l){l.moveTo(e,n,t.timeStamp);let c=l.way==="tie"?pr(this.viewport,e,n,this.reach(t)):null;this.viewport.marks.hover=l instanceof fa?l.ring:c,this.viewport.marks.dirty=!0}else{if(this.hands.size)return;r.button!==0||r.shift||this.near?this.viewport.camera.pan(o,a):this.viewport.camera.orbit(o,a)}}drag(t){let e=this.hands.get(t.pointerId);if(!e||!this.moved||this.menuOpened)return;let{x:n,y:s}=this.at(t);e.moveTo(n,s,t.timeStamp)}lift(t){if(!this.down.delete(t.pointerId))return;clearTimeout(this.longPress);let{x:e,y:n}=this.at(t),s=this.hands.get(t.pointerId);s&&this.moved&&s.moveTo(e,n,t.timeStamp);let o=s?.way==="tie"&&this.moved&&!this.menuOpened?pr(this.viewport,e,n,this.reach(t)):null,a=s!==void 0&&this.moved;this.dropHand(t.pointerId,t.shiftKey||this.keep,this.moved,t.timeStamp);let{layout:l}=this.viewport.session;s instanceof pa&&o&&ts(l,o).node!==s.node&&this.actions.tie(s.hit,o),!(this.moved||this.menuOpened||a||this.down.size)&&(t.button===2?this.openMenu(e,n):t.button===0&&this.click(t.timeStamp))}click(t){if(this.hit&&this.tool!=="hand"&&this.tool!=="kick"){this.actions.use(this.tool,this.hit);return}this.hit||this.body||(t-this.lastClick<Pw&&this.letGo(),this.lastClick=t)}letGo(){this.viewport.session.send({type:"let_go"})}openMenu(t,e){this.menuOpened=!0,this.dropHands(!1,!1),this.actions.menu(this.hit??this.body,t,e)}dropHand(t,e,n=!0,s=1/0){let r=this.hands.get(t);r&&(this.hands.delete(t),n&&r.release(e,s),this.hover(null))}dropHands(t,e=!0){for(let n of[...this.hands.keys()])this.dropHand(n,t,e)}leaveOff(){this.dropHands(!1),this.menuOpened=this.down.size>0}look(){if(this.down.size)return;let{resting:t}=this,e=t&&pr(this.viewport,t.x,t.y,ng),n=t&&!e&&this.tool==="hand";this.hover(e??(n?Id(this.viewport,t.x,t.y)?.place??null:null))}pinch(t,e,n){let s=[...this.down.entries()].find(([l])=>l!==t)?.[1],r=this.down.get(t);if(!s||!r)return;let[o,a]=[r,{x:e,y:n}].map(l=>Math.hypot(l.x-s.x,l.y-s.y));this.viewport.camera.pan((e-r.x)/2,(n-r.y)/2),a>1&&this.viewport.camera.zoom(o/a,(e+s.x)/2,(n+s.y)/2),this.down.set(t,{x:e,y:n})}wheel(t){t.preventDefault();let{x:e,y:n}=this.at(t),s=t.deltaMode===1?18:1;this.viewport.flight=null,this.viewport.camera.zoom(Math.exp(Math.max(-60,Math.min(60,t.deltaY*s))*.003),e,n)}hover(t){let{marks:e}=this.viewport;t===null&&e.hover===null||(e.hover=t,e.dirty=!0,this.element.classList.toggle("over",t!==null))}};var Qe=["#3b8bc4","#d9652b","#1f9e77","#c879a7","#d99a1c","#5ab4e0","#8a8f98"];var Lw=[[.555,.159,276],[.628,.114,307],[.719,.116,356],[.776,.105,32],[.828,.11,60],[.915,.142,103]],Nw=[[.346,.12,275],[.475,.135,315],[.555,.14,352],[.63,.165,22],[.7,.135,48],[.765,.15,82]],ig=i=>i?1:.42,sg=i=>i?.022:.04,Dw=(i,t,e)=>{let n=e*Math.PI/180;return[i,t*Math.cos(n),t*Math.sin(n)]};function Ow([i,t,e]){let n=(i+.3963377774*t+.2158037573*e)**3,s=(i-.1055613458*t-.0638541728*e)**3,r=(i-.0894841775*t-1.291485548*e)**3;return[4.0767416621*n-3.3077115913*s+.2309699292*r,-1.2684380046*n+2.6097574011*s-.3413193965*r,-.0041960863*n-.7034186147*s+1.707614701*r]}var Fw=i=>{let t=Math.min(1,Math.max(0,i));return t<=.0031308?12.92*t:1.055*t**(1/2.4)-.055};function io(i){let t=i?Lw:Nw,e=[],n=t.length-1;for(let a=0;a<=4e3;a++){let l=a/4e3*n,c=Math.min(n-1,Math.floor(l)),h=l-c,[u,d]=[t[c],t[c+1]],f=d[2]-u[2];f<-180&&(f+=360);let p=u[2]+h*f;e.push(Dw(u[0]+h*(d[0]-u[0]),u[1]+h*(d[1]-u[1]),p))}let s=[0];for(let a=1;a<e.length;a++){let[l,c]=[e[a-1],e[a]];s.push(s[a-1]+Math.hypot(c[0]-l[0],c[1]-l[1],c[2]-l[2]))}let r=[],o=0;for(let a=0;a<256;a++){let l=s[s.length-1]*a/255;for(;o<s.length-1&&s[o]<l;)o++;r.push(Ow(e[o]).map(Fw))}return r}function gr(i){let t=parseInt(i.slice(1),16);return[(t>>16&255)/255,(t>>8&255)/255,(t&255)/255]}function Ue(i,t=1){let[e,n,s]=[0,1,2].map(r=>Math.round(255*i[r]));return t<1?`rgba(${e}, ${n}, ${s}, ${t})`:`rgb(${e}, ${n}, ${s})`}function z(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))r!=null&&(s.startsWith("on")?n.addEventListener(s.slice(2),r):s.includes("-")||s==="role"||s==="for"?n.setAttribute(s,String(r)):s==="data"?Object.assign(n.dataset,r):Object.assign(n,{[s]:r}));for(let s of e)s&&n.append(s);return n}var rg="http://www.w3.org/2000/svg",Uw={play:"M8 5.5v13l10.5-6.5z",pause:"M8 5v14M16 5v14",step:"M6 5.5v13l9-6.5zM18.5 5v14",reset:"M5 12a7 7 0 1 0 2.3-5.2M5 4.5v4.2h4.2",fit:"M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5",hand:"M8.5 12V6.2a1.4 1.4 0 0 1 2.8 0V11M11.3 10V4.9a1.4 1.4 0 0 1 2.8 0V11M14.1 10.5V6.3a1.4 1.4 0 0 1 2.8 0V14c0 4-2 6.5-5.3 6.5-3 0-4.3-1.5-5.8-4.2L4 13.2c-.8-1.5 1.1-2.6 2.2-1.3l2.3 2.6",pin:"M9 3.5h6M10 3.5l-.6 6.2L6.5 13h11l-2.9-3.3L14 3.5M12 13v7.5",cut:"M6.5 19.5a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4zM17.5 19.5a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4zM8 15.5L16.5 4M16 15.5L7.5 4",load:"M12 3v5M12 8a1.5 1.5 0 0 0 0 0M7.5 10h9l2.5 10H5z",tie:"M3.5 8.5c6 0 11 7 17 7M3.5 15.5c6 0 11-7 17-7M12 9.2a2.8 2.8 0 1 1 0 5.6 2.8 2.8 0 0 1 0-5.6z",kick:"M4 12h13M12 6l6 6-6 6",follow:"M4 18c3-9 6 1 9-6 2-4.5 4-4 7-6",graph:"M4 4v16h16M7.5 15l3.5-5 3.5 3 5-7.5",scenes:"M4 5.5h7v5.5H4zM13.5 5.5H20v5.5h-6.5zM4 13.5h7V19H4zM13.5 13.5H20V19h-6.5z",tour:"M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18zM15.8 8.2l-2.3 5.3-5.3 2.3 2.3-5.3z",compare:"M12 3.5v17M4 6.5h5v11H4zM15 6.5h5v11h-5z",keep:"M12 4v10.5M7.5 10.5L12 15l4.5-4.5M4.5 16v3.5h15V16",help:"M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18zM9.5 9.5a2.6 2.6 0 1 1 3.6 2.4c-.8.4-1.1.9-1.1 1.8M12 16.8v.2",theme:"M12 20.5a8.5 8.5 0 1 0 0-17zM12 20.5a8.5 8.5 0 0 1 0-17",panel:"M4 7h9M17 7h3M15 5v4M4 12h3M11 12h9M9 10v4M4 17h11M19 17h1M17 15v4",more:"M5.5 11.2a.8.8 0 1 0 0 1.6.8.8 0 0 0 0-1.6zM12 11.2a.8.8 0 1 0 0 1.6.8.8 0 0 0 0-1.6zM18.5 11.2a.8.8 0 1 0 0 1.6.8.8 0 0 0 0-1.6z",close:"M6 6l12 12M18 6L6 18",down:"M6 9.5l6 6 6-6",link:"M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-1 1M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l1-1",sound:"M4 9.5v5h3.5L12 18.5v-13L7.5 9.5zM15 9.5a3.5 3.5 0 0 1 0 5M17.5 7a7 7 0 0 1 0 10",undo:"M8.5 6L4.5 10l4 4M4.5 10h9a5.5 5.5 0 0 1 0 11h-2"};function bi(i,t=!1){let e=document.createElementNS(rg,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true"),e.classList.add("icon"),t&&e.classList.add("solid");let n=document.createElementNS(rg,"path");return n.setAttribute("d",Uw[i]),e.append(n),e}function wn(i,t,e,n={}){let s=n.key?`${t} (${n.key})`:t;return z("button",{type:"button",title:s,"aria-label":t,onclick:e,id:n.id??"",className:n.kind??"plain"},bi(i,i==="play"),n.words&&z("span",{className:"words"},n.words))}function Nl(i,t){let e=wn("more",t,()=>n(!i.classList.contains("unfolded")),{kind:"plain fold"}),n=s=>{i.classList.toggle("unfolded",s),e.setAttribute("aria-expanded",String(s))};return n(!1),i.addEventListener("click",({target:s})=>{s instanceof Element&&s.closest("button:not(.fold)")&&n(!1)}),e}function so(i,t,...e){let n=z("button",{type:"button",className:"plain close","aria-label":"Close",title:"Close"},bi("close")),s=z("dialog",{className:`window ${t}`,"aria-label":i},z("header",{},z("h2",{},i),n),...e);return n.onclick=()=>s.close(),s.addEventListener("close",()=>{document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),s.addEventListener("click",r=>{r.target===s&&s.close()}),s}function ro(i,t,e,n,s=""){i.querySelector(".popup")?.remove();let r=z("div",{className:"popup",role:"menu"},s&&z("div",{className:"popup-title"},s)),o=document.activeElement,a=()=>{let u=r.contains(document.activeElement);r.remove(),u&&o instanceof HTMLElement&&o.focus({preventScroll:!0}),removeEventListener("pointerdown",l,!0),removeEventListener("keydown",c,!0)},l=u=>{r.contains(u.target)||a()},c=u=>{u.key==="Escape"&&a()};r.addEventListener("keydown",u=>kw(r,u));for(let u of n){let d=()=>{a(),u.press()};r.append(z("button",{type:"button",role:"menuitem",onclick:d,disabled:u.disabled??!1,id:u.id??""},u.label,u.hint&&z("small",{},u.hint)))}i.append(r);let h=i.getBoundingClientRect();return r.style.left=`${Math.max(4,Math.min(t,h.width-r.offsetWidth-4))}px`,r.style.top=`${Math.max(4,Math.min(e,h.height-r.offsetHeight-4))}px`,addEventListener("pointerdown",l,!0),addEventListener("keydown",c,!0),r.querySelector("button")?.focus({preventScroll:!0}),r}function kw(i,t){let n=[...i.querySelectorAll("button")].filter(o=>!o.disabled),s=n.findIndex(o=>o===document.activeElement),r={ArrowDown:s+1,ArrowUp:s-1,Home:0,End:n.length-1}[t.key];r===void 0||!n.length||(t.preventDefault(),t.stopPropagation(),n[(r+n.length)%n.length].focus({preventScroll:!0}))}function Pd(i,t){let e=z("a",{href:i,download:t});document.body.append(e),e.click(),e.remove()}var Dl=class{constructor(){this.count=0,this.start=0,this.time=new Float64Array(2*7200),this.apart=new Uint8Array(2*7200),this.columns=new Map,this.of=[]}clear(){this.count=this.start=0,this.columns.clear()}tell(t){for(let[e,[n,s]]of t.entries())if(s!==this.of[e]){this.of[e]=s;for(let r of this.columns.keys())n.test(r)&&this.columns.delete(r)}}add(t,e,n=1/0){if(this.count>0&&t<=this.last){if(t===this.last)return;this.count=this.search(t)}if(this.start+this.count===2*7200){for(let r of[this.time,this.apart,...this.columns.values()])r.copyWithin(0,this.start+1);this.start=0,this.count=7199}let s=this.start+this.count;this.apart[s]=t-this.last>n?1:0,this.time[s]=t;for(let r of this.columns.values())r[s]=NaN;for(let[r,o]of e){let a=this.columns.get(r);a||(a=new Float64Array(2*7200).fill(NaN),this.columns.set(r,a)),a[s]=o}this.count++,this.count>7200&&(this.count=7200,this.start++)}get last(){return this.count?this.time[this.start+this.count-1]:NaN}get first(){return this.count?this.time[this.start]:NaN}between(t,e,n){let[s,r]=this.ends(t,e),o=new Float64Array(r-s).fill(NaN);return[this.time.subarray(s,r),...n.map(a=>this.columns.get(a)?.subarray(s,r)??o)]}apartBetween(t,e){return this.apart.subarray(...this.ends(t,e))}ends(t,e){let n=Math.max(0,this.search(t)-1),s=Math.min(this.count,this.search(e)+1);return[this.start+n,this.start+s]}search(t){let[e,n]=[0,this.count];for(;e<n;){let s=e+n>>1;this.time[this.start+s]<t?e=s+1:n=s}return e}};var ni={left:46,right:10,top:8,bottom:34},Ol=class{constructor(t){this.canvas=z("canvas",{className:"phase"}),this.host=t,t.append(this.canvas)}resize(){let t=devicePixelRatio||1,{clientWidth:e,clientHeight:n}=this.host,[s,r]=[e*t,n*t].map(Math.round);(this.canvas.width!==s||this.canvas.height!==r)&&(this.canvas.width=s,this.canvas.height=r)}show(t,e,n){let s=this.canvas.getContext("2d");if(!s)return;let r=devicePixelRatio||1,[o,a]=[this.canvas.width/r,this.canvas.height/r];s.setTransform(r,0,0,r,0,0),s.clearRect(0,0,o,a);let l=[];for(let w=1;w+1<t.length;w++){let R=(e[w+1]-e[w-1])/(t[w+1]-t[w-1]);Number.isFinite(R)&&l.push([e[w],R])}let c=getComputedStyle(document.documentElement),h=c.getPropertyValue("--faint").trim();if(s.font="11px system-ui, sans-serif",s.fillStyle=h,l.length<3){s.fillText("Follow a node to see its phase plane.",12,24);return}let[u,d]=og(l.map(([w])=>w)),[f,p]=og(l.map(([,w])=>w)),x={w:o-ni.left-ni.right,h:a-ni.top-ni.bottom},g=w=>ni.left+(w-u)/(d-u)*x.w,m=w=>ni.top+(1-(w-f)/(p-f))*x.h;s.strokeStyle=c.getPropertyValue("--line").trim(),s.strokeRect(ni.left,ni.top,x.w,x.h),f<0&&p>0&&(s.beginPath(),s.moveTo(ni.left,m(0)),s.lineTo(ni.left+x.w,m(0)),s.stroke()),s.textAlign="right";for(let w of[f,p])s.fillText(Te(Number(w.toPrecision(2))),ni.left-4,m(w)+(w===f?0:9));s.textAlign="left",s.fillText(Te(Number(u.toPrecision(3))),ni.left,a-20),s.textAlign="right",s.fillText(ce(Number(d.toPrecision(3)),"m"),o-ni.right,a-20),s.textAlign="center",s.fillText("height; upward velocity in m/s",ni.left+x.w/2,a-5),s.textAlign="left",s.strokeStyle=n,s.lineWidth=1.4,s.beginPath();for(let[w,R]of l)s.lineTo(g(w),m(R));s.stroke();let[v,M]=l[l.length-1];s.fillStyle=n,s.beginPath(),s.arc(g(v),m(M),4,0,2*Math.PI),s.fill()}};function og(i){let[t,e]=[1/0,-1/0];for(let s of i)t=Math.min(t,s),e=Math.max(e,s);let n=Math.max(1e-6,.06*(e-t));return[t-n,e+n]}var Bw="uplot",zw="u-hz",Hw="u-vt",Vw="u-title",Gw="u-wrap",Ww="u-under",$w="u-over",Xw="u-axis",yr="u-off",qw="u-select",Yw="u-cursor-x",Kw="u-cursor-y",Zw="u-cursor-pt",Jw="u-legend",jw="u-live",Qw="u-inline",tb="u-series",eb="u-marker",ag="u-label",nb="u-value",ga="width",xa="height";var lg="bottom",oo="left",Ld="right",Kd="#000",cg=Kd+"0",Nd="mousemove",hg="mousedown",Dd="mouseup",ug="mouseenter",dg="mouseleave",fg="dblclick",ib="resize",sb="scroll",pg="change",zl="dppxchange",Zd="--",po=typeof window<"u",Bd=po?document:null,lo=po?window:null,rb=po?navigator:null,Ce,Fl;function zd(){let i=devicePixelRatio;Ce!=i&&(Ce=i,Fl&&Vd(pg,Fl,zd),Fl=matchMedia(`(min-resolution: ${Ce-.001}dppx) and (max-resolution: ${Ce+.001}dppx)`),_r(pg,Fl,zd),lo.dispatchEvent(new CustomEvent(zl)))}function li(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Hd(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Ke(i,t,e){i.style[t]=e+"px"}function Ni(i,t,e,n){let s=Bd.createElement(i);return t!=null&&li(s,t),e?.insertBefore(s,n),s}function Mi(i,t){return Ni("div",i,t)}var mg=new WeakMap;function es(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=mg.get(i);r!=o&&(i.style.transform=r,mg.set(i,r),t<0||e<0||t>n||e>s?li(i,yr):Hd(i,yr))}var gg=new WeakMap;function xg(i,t,e){let n=t+e,s=gg.get(i);n!=s&&(gg.set(i,n),i.style.background=t,i.style.borderColor=e)}var vg=new WeakMap;function yg(i,t,e,n){let s=t+""+e,r=vg.get(i);s!=r&&(vg.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var Jd={passive:!0},ob={...Jd,capture:!0};function _r(i,t,e,n){t.addEventListener(i,e,n?ob:Jd)}function Vd(i,t,e,n){t.removeEventListener(i,e,Jd)}po&&zd();function Di(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:ci((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function qg(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var Yg=i=>i!=null,Kg=i=>i!=null&&i>0,Gl=qg(Yg),ab=qg(Kg);function lb(i,t,e,n=0,s=!1){let r=s?ab:Gl,o=s?Kg:Yg;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??ze,l??-ze]}function Wl(i,t,e,n){let s=bg(i),r=bg(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?vs:Zg,a=s==1?ci:Si,l=r==1?Si:ci,c=a(o(Rn(i))),h=l(o(Rn(t))),u=co(e,c),d=co(e,h);return e==10&&(c<0&&(u=He(u,-c)),h<0&&(d=He(d,-h))),n||e==2?(i=u*s,t=d*r):(i=t0(i,u),t=$l(t,d)),[i,t]}function jd(i,t,e,n){let s=Wl(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var Qd=.1,_g={mode:3,pad:Qd},ya={pad:0,soft:null,mode:0},cb={min:ya,max:ya};function Hl(i,t,e,n){return Xl(e)?wg(i,t,e):(ya.pad=e,ya.soft=n?0:null,ya.mode=n?3:0,wg(i,t,cb))}function Ae(i,t){return i??t}function hb(i,t,e){for(t=Ae(t,0),e=Ae(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function wg(i,t,e){let n=e.min,s=e.max,r=Ae(n.pad,0),o=Ae(s.pad,0),a=Ae(n.hard,-ze),l=Ae(s.hard,ze),c=Ae(n.soft,ze),h=Ae(s.soft,-ze),u=Ae(n.mode,0),d=Ae(s.mode,0),f=t-i,p=vs(f),x=Qn(Rn(i),Rn(t)),g=vs(x),m=Rn(g-p);(f<1e-24||m>10)&&(f=0,(i==0||t==0)&&(f=1e-24,u==2&&c!=ze&&(r=0),d==2&&h!=-ze&&(o=0)));let v=f||x||1e3,M=vs(v),w=co(10,ci(M)),R=v*(f==0?i==0?.1:1:r),T=He(t0(i-R,w/10),24),y=i>=c&&(u==1||u==3&&T<=c||u==2&&T>=c)?c:ze,A=Qn(a,T<y&&i>=y?y:Oi(y,T)),U=v*(f==0?t==0?.1:1:o),N=He($l(t+U,w/10),24),P=t<=h&&(d==1||d==3&&N>=h||d==2&&N<=h)?h:-ze,G=Oi(l,N>P&&t<=P?P:Qn(P,N));return A==G&&A==0&&(G=100),[A,G]}var ub=new Intl.NumberFormat(po?rb.language:"en-US"),tf=i=>ub.format(i),hi=Math,Bl=hi.PI,Rn=hi.abs,ci=hi.floor,An=hi.round,Si=hi.ceil,Oi=hi.min,Qn=hi.max,co=hi.pow,bg=hi.sign,vs=hi.log10,Zg=hi.log2,db=(i,t=1)=>hi.sinh(i)*t,Od=(i,t=1)=>hi.asinh(i/t),ze=1/0;function Mg(i){return(vs((i^i>>31)-(i>>31))|0)+1}function Gd(i,t,e){return Oi(Qn(i,t),e)}function Jg(i){return typeof i=="function"}function ye(i){return Jg(i)?i:()=>i}var fb=()=>{},jg=i=>i,Qg=(i,t)=>t,pb=i=>null,Sg=i=>!0,Eg=(i,t)=>i==t,mb=/\.\d*?(?=9{6,}|0{6,})/gm,wr=i=>{if(n0(i)||Vs.has(i))return i;let t=`${i}`,e=t.match(mb);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${wr(s)}e${r}`}return He(i,n)};function xr(i,t){return wr(He(wr(i/t))*t)}function $l(i,t){return wr(Si(wr(i/t))*t)}function t0(i,t){return wr(ci(wr(i/t))*t)}function He(i,t=0){if(n0(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return An(n)/e}var Vs=new Map;function e0(i){return((""+i).split(".")[1]||"").length}function wa(i,t,e,n){let s=[],r=n.map(e0);for(let o=t;o<e;o++){let a=Rn(o),l=He(co(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:He(h,u);s.push(d),Vs.set(d,u)}}return s}var _a={},ef=[],ho=[null,null],Hs=Array.isArray,n0=Number.isInteger,gb=i=>i===void 0;function Tg(i){return typeof i=="string"}function Xl(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function xb(i){return i!=null&&typeof i=="object"}var vb=Object.getPrototypeOf(Uint8Array),i0="__proto__";function uo(i,t=Xl){let e;if(Hs(i)){let n=i.find(s=>s!=null);if(Hs(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=uo(i[s],t)}else e=i.slice()}else if(i instanceof vb)e=i.slice();else if(t(i)){e={};for(let n in i)n!=i0&&(e[n]=uo(i[n],t))}else e=i;return e}function bn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=i0&&(Xl(i[s])?bn(i[s],uo(n[s])):i[s]=uo(n[s]))}return i}var yb=0,_b=1,wb=2;function bb(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function Mb(i,t){if(Tb(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Ab(o[0])||(o=Eb(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=t?t[o][c]:_b,f=[];for(let p=0;p<h.length;p++){let x=h[p],g=r.get(l[p]);x===null?d!=yb&&(u[g]=x,d==wb&&f.push(g)):u[g]=x}bb(u,f,s),n.push(u)}}return n}var Sb=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Eb(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function Tb(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Ab(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Qn(1,ci((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var s0=["January","February","March","April","May","June","July","August","September","October","November","December"],r0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function o0(i){return i.slice(0,3)}var Rb=r0.map(o0),Cb=s0.map(o0),Ib={MMMM:s0,MMM:Cb,WWWW:r0,WWW:Rb};function ma(i){return(i<10?"0":"")+i}function Pb(i){return(i<10?"00":i<100?"0":"")+i}var Lb={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>ma(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ma(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>ma(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ma(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ma(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Pb(i.getMilliseconds())};function nf(i,t){t=t||Ib;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?Lb[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var Nb=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Db(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==Nb?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var a0=i=>i%1==0,Vl=[1,2,2.5,5],Ob=wa(10,-32,0,Vl),l0=wa(10,0,32,Vl),Fb=l0.filter(a0),vr=Ob.concat(l0),sf=`
`,c0="{YYYY}",Ag=sf+c0,h0="{M}/{D}",va=sf+h0,Ul=va+"/{YY}",u0="{aa}",Ub="{h}:{mm}",ao=Ub+u0,Rg=sf+ao,Cg=":{ss}",Ie=null;function d0(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?wa(10,0,3,Vl).filter(a0):wa(10,-3,0,Vl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,c0,Ie,Ie,Ie,Ie,Ie,Ie,1],[s*28,"{MMM}",Ag,Ie,Ie,Ie,Ie,Ie,1],[s,h0,Ag,Ie,Ie,Ie,Ie,Ie,1],[n,"{h}"+u0,Ul,Ie,va,Ie,Ie,Ie,1],[e,ao,Ul,Ie,va,Ie,Ie,Ie,1],[t,Cg,Ul+" "+ao,Ie,va+" "+ao,Ie,Rg,Ie,1],[i,Cg+".{fff}",Ul+" "+ao,Ie,va+" "+ao,Ie,Rg,Ie,1]];function h(u){return(d,f,p,x,g,m)=>{let v=[],M=g>=o,w=g>=r&&g<o,R=u(p),T=He(R*i,3),y=Fd(R.getFullYear(),M?0:R.getMonth(),w||M?1:R.getDate()),A=He(y*i,3);if(w||M){let U=w?g/r:0,N=M?g/o:0,P=T==A?T:He(Fd(y.getFullYear()+N,y.getMonth()+U,1)*i,3),G=new Date(An(P/i)),W=G.getFullYear(),D=G.getMonth();for(let V=0;P<=x;V++){let $=Fd(W+N*V,D+U*V,1),k=$-u(He($*i,3));P=He((+$+k)*i,3),P<=x&&v.push(P)}}else{let U=g>=s?s:g,N=ci(p)-ci(T),P=A+N+$l(T-A,U);v.push(P);let G=u(P),W=G.getHours()+G.getMinutes()/e+G.getSeconds()/n,D=g/n,V=d.axes[f]._space,$=m/V;for(;P=He(P+g,i==1?0:3),!(P>x);)if(D>1){let k=ci(He(W+D,6))%24,Q=u(P).getHours()-k;Q>1&&(Q=-1),P-=Q*n,W=(W+D)%24;let st=v[v.length-1];He((P-st)/g,3)*$>=.7&&v.push(P)}else v.push(P)}return v}}return[l,c,h]}var[kb,Bb,zb]=d0(1),[Hb,Vb,Gb]=d0(.001);wa(2,-53,53,[1]);function Ig(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Pg(i,t){return(e,n,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,h,u,d,f;return n.map(p=>{let x=i(p),g=x.getFullYear(),m=x.getMonth(),v=x.getDate(),M=x.getHours(),w=x.getMinutes(),R=x.getSeconds(),T=g!=l&&a[2]||m!=c&&a[3]||v!=h&&a[4]||M!=u&&a[5]||w!=d&&a[6]||R!=f&&a[7]||a[1];return l=g,c=m,h=v,u=M,d=w,f=R,T(x)})}}function Wb(i,t){let e=nf(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Fd(i,t,e){return new Date(i,t,e)}function Lg(i,t){return t(i)}var $b="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Ng(i,t){return(e,n,s,r)=>r==null?Zd:t(i(n))}function Xb(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function qb(i,t){return i.series[t].fill(i,t)}var Yb={show:!0,live:!0,isolate:!1,mount:fb,markers:{show:!0,width:2,stroke:Xb,fill:qb,dash:"solid"},idx:null,idxs:null,values:[]};function Kb(i,t){let e=i.cursor.points,n=Mi(),s=e.size(i,t);Ke(n,ga,s),Ke(n,xa,s);let r=s/-2;Ke(n,"marginLeft",r),Ke(n,"marginTop",r);let o=e.width(i,t,s);return o&&Ke(n,"borderWidth",o),n}function Zb(i,t){let e=i.series[t].points;return e._fill||e._stroke}function Jb(i,t){let e=i.series[t].points;return e._stroke||e._fill}function jb(i,t){return i.series[t].points.size}var Ud=[0,0];function Qb(i,t,e){return Ud[0]=t,Ud[1]=e,Ud}function kl(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function kd(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var tM={show:!0,x:!0,y:!0,lock:!1,move:Qb,points:{one:!1,show:Kb,size:jb,width:0,stroke:Jb,fill:Zb},bind:{mousedown:kl,mouseup:kl,click:kl,dblclick:kl,mousemove:kd,mouseleave:kd,mouseenter:kd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},f0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},rf=bn({},f0,{filter:Qg}),p0=bn({},rf,{size:10}),m0=bn({},f0,{show:!1}),of='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',g0="bold "+of,x0=1.5,Dg={show:!0,scale:"x",stroke:Kd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:g0,side:2,grid:rf,ticks:p0,border:m0,font:of,lineGap:x0,rotate:0},eM="Value",nM="Time",Og={show:!0,scale:"x",auto:!1,sorted:1,min:ze,max:-ze,idxs:[]};function iM(i,t,e,n,s){return t.map(r=>r==null?"":tf(r))}function sM(i,t,e,n,s,r,o){let a=[],l=Vs.get(s)||0;e=o?e:He($l(e,s),l);for(let c=e;c<=n;c=He(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Wd(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?vs:Zg,h=ci(c(e));s=co(l,h),l==10&&(s=vr[Di(s,vr)]);let u=e,d=s*l;l==10&&(d=vr[Di(d,vr)]);do a.push(u),u=u+s,l==10&&!Vs.has(u)&&(u=He(u,Vs.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=vr[Di(d,vr)]));while(u<=n);return a}function rM(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Wd(i,t,Qn(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?Wd(i,t,Qn(l,-n),-e,s):[l]).reverse().map(d=>-d).concat(h,c)}var v0=/./,oM=/[12357]/,aM=/[125]/,Fg=/1/,$d=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function lM(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?v0:l(7,o)-h>=c?oM:l(5,o)-h>=c?aM:Fg;if(u==Fg){let d=Rn(l(1,o)-h);if(d<c)return $d(t.slice().reverse(),a.distr,u,Si(c/d)).reverse()}return $d(t,a.distr,u,1)}function cM(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=Rn(l(1,o)-l(2,o));return c<a?$d(t.slice().reverse(),3,v0,Si(a/c)).reverse():t}function hM(i,t,e,n){return n==null?Zd:t==null?"":tf(t)}var Ug={show:!0,scale:"y",stroke:Kd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:g0,side:3,grid:rf,ticks:p0,border:m0,font:of,lineGap:x0,rotate:0};function uM(i,t){let e=3+(i||1)*2;return He(e*t,3)}function dM(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=Rn(o-r),l=i.series[t],c=a/(l.points.space*Ce);return n[1]-n[0]<=c}var kg={scale:null,auto:!0,sorted:0,min:ze,max:-ze},y0=(i,t,e,n,s)=>s,Bg={show:!0,auto:!0,sorted:0,gaps:y0,alpha:1,facets:[bn({},kg,{scale:"x"}),bn({},kg,{scale:"y"})]},zg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:y0,alpha:1,points:{show:dM,filter:null},values:null,min:ze,max:-ze,idxs:[],path:null,clip:null};function fM(i,t,e,n,s){return e/10}var _0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},pM=bn({},_0,{time:!1,ori:1}),Hg={};function w0(i,t){let e=Hg[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Hg[i]=e)),e}var fo=1,Xd=2;function br(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,x=a.height,g=i.valToPosH,m=i.valToPosV;return h.ori==0?e(s,l,c,h,u,g,m,d,f,p,x,Yl,mo,Zl,M0,E0):e(s,l,c,h,u,m,g,f,d,x,p,Kl,go,cf,S0,T0)}function af(i,t){let e=0,n=0,s=Ae(i.bands,ef);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function mM(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ys(i,t,e,n,s,r){return br(i,t,(o,a,l,c,h,u,d,f,p,x,g)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),M=c.ori==0?mo:go,w,R;v==1?(w=e,R=n):(w=n,R=e);let T=m(u(a[w],c,x,f)),y=m(d(l[w],h,g,p)),A=m(u(a[R],c,x,f)),U=m(d(r==1?h.max:h.min,h,g,p)),N=new Path2D(s);return M(N,A,U),M(N,T,U),M(N,T,y),N})}function ql(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?Zl:cf,l=e;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function gM(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function lf(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(i[u]),p=d==u?f:r(i[d]),x=u-s;f=o<=0&&x>=0&&x<l?r(i[x]):f;let m=d+s;p=o>=0&&m>=0&&m<l?r(i[m]):p,p>=f&&a.push([f,p])}return a}function Vg(i){return i==0?jg:i==1?An:t=>xr(t,i)}function b0(i){let t=i==0?Yl:Kl,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Oi(c,a/2,l/2),h=Oi(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var Yl=(i,t,e)=>{i.moveTo(t,e)},Kl=(i,t,e)=>{i.moveTo(e,t)},mo=(i,t,e)=>{i.lineTo(t,e)},go=(i,t,e)=>{i.lineTo(e,t)},Zl=b0(0),cf=b0(1),M0=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},S0=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},E0=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},T0=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function A0(i){return(t,e,n,s,r)=>br(t,e,(o,a,l,c,h,u,d,f,p,x,g)=>{let{pxRound:m,points:v}=o,M,w;c.ori==0?(M=Yl,w=M0):(M=Kl,w=S0);let R=He(v.width*Ce,3),T=(v.size-v.width)/2*Ce,y=He(T*2,3),A=new Path2D,U=new Path2D,{left:N,top:P,width:G,height:W}=t.bbox;Zl(U,N-y,P-y,G+y*2,W+y*2);let D=V=>{if(l[V]!=null){let $=m(u(a[V],c,x,f)),k=m(d(l[V],h,g,p));M(A,$+T,k),w(A,$,k,T,0,Bl*2)}};if(r)r.forEach(D);else for(let V=n;V<=s;V++)D(V);return{stroke:R>0?A:null,fill:A,clip:U,flags:fo|Xd}})}function R0(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var xM=R0(mo),vM=R0(go);function C0(i){let t=Ae(i?.alignGaps,0);return(e,n,s,r)=>br(e,n,(o,a,l,c,h,u,d,f,p,x,g)=>{[s,r]=Gl(l,s,r);let m=o.pxRound,v=W=>m(u(W,c,x,f)),M=W=>m(d(W,h,g,p)),w,R;c.ori==0?(w=mo,R=xM):(w=go,R=vM);let T=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fo},A=y.stroke,U=!1;if(r-s>=x*4){let W=dt=>e.posToVal(dt,c.key,!0),D=null,V=null,$,k,ot,K=v(a[T==1?s:r]),Q=v(a[s]),st=v(a[r]),ft=W(T==1?Q+1:st-1);for(let dt=T==1?s:r;dt>=s&&dt<=r;dt+=T){let tt=a[dt],yt=(T==1?tt<ft:tt>ft)?K:v(tt),Rt=l[dt];yt==K?Rt!=null?(k=Rt,D==null?(w(A,yt,M(k)),$=D=V=k):k<D?D=k:k>V&&(V=k)):Rt===null&&(U=!0):(D!=null&&R(A,K,M(D),M(V),M($),M(k)),Rt!=null?(k=Rt,w(A,yt,M(k)),D=V=$=k):(D=V=null,Rt===null&&(U=!0)),K=yt,ft=W(K+T))}D!=null&&D!=V&&ot!=K&&R(A,K,M(D),M(V),M($),M(k))}else for(let W=T==1?s:r;W>=s&&W<=r;W+=T){let D=l[W];D===null?U=!0:D!=null&&w(A,v(a[W]),M(D))}let[P,G]=af(e,n);if(o.fill!=null||P!=0){let W=y.fill=new Path2D(A),D=o.fillTo(e,n,o.min,o.max,P),V=M(D),$=v(a[s]),k=v(a[r]);T==-1&&([k,$]=[$,k]),w(W,k,V),w(W,$,V)}if(!o.spanGaps){let W=[];U&&W.push(...lf(a,l,s,r,T,v,t)),y.gaps=W=o.gaps(e,n,s,r,W),y.clip=ql(W,c.ori,f,p,x,g)}return G!=0&&(y.band=G==2?[ys(e,n,s,r,A,-1),ys(e,n,s,r,A,1)]:ys(e,n,s,r,A,G)),y})}function yM(i){let t=Ae(i.align,1),e=Ae(i.ascDesc,!1),n=Ae(i.alignGaps,0),s=Ae(i.extend,!1);return(r,o,a,l)=>br(r,o,(c,h,u,d,f,p,x,g,m,v,M)=>{[a,l]=Gl(u,a,l);let w=c.pxRound,{left:R,width:T}=r.bbox,y=Q=>w(p(Q,d,v,g)),A=Q=>w(x(Q,f,M,m)),U=d.ori==0?mo:go,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fo},P=N.stroke,G=d.dir*(d.ori==0?1:-1),W=A(u[G==1?a:l]),D=y(h[G==1?a:l]),V=D,$=D;s&&t==-1&&($=R,U(P,$,W)),U(P,D,W);for(let Q=G==1?a:l;Q>=a&&Q<=l;Q+=G){let st=u[Q];if(st==null)continue;let ft=y(h[Q]),dt=A(st);t==1?U(P,ft,W):U(P,V,dt),U(P,ft,dt),W=dt,V=ft}let k=V;s&&t==1&&(k=R+T,U(P,k,W));let[ot,K]=af(r,o);if(c.fill!=null||ot!=0){let Q=N.fill=new Path2D(P),st=c.fillTo(r,o,c.min,c.max,ot),ft=A(st);U(Q,k,ft),U(Q,$,ft)}if(!c.spanGaps){let Q=[];Q.push(...lf(h,u,a,l,G,y,n));let st=c.width*Ce/2,ft=e||t==1?st:-st,dt=e||t==-1?-st:st;Q.forEach(tt=>{tt[0]+=ft,tt[1]+=dt}),N.gaps=Q=c.gaps(r,o,a,l,Q),N.clip=ql(Q,d.ori,g,m,v,M)}return K!=0&&(N.band=K==2?[ys(r,o,a,l,P,-1),ys(r,o,a,l,P,1)]:ys(r,o,a,l,P,K)),N})}function Gg(i,t,e,n,s,r,o=ze){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=Rn(i[l]-i[a]);h<c&&(c=h,o=Rn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function _M(i){i=i||_a;let t=Ae(i.size,[.6,ze,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ye(s),o=1-t[0],a=Ae(t[1],ze),l=Ae(t[2],1),c=Ae(i.disp,_a),h=Ae(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,p,x,g)=>br(f,p,(m,v,M,w,R,T,y,A,U,N,P)=>{let G=m.pxRound,W=e,D=n*Ce,V=a*Ce,$=l*Ce,k,ot;w.ori==0?[k,ot]=r(f,p):[ot,k]=r(f,p);let K=w.dir*(w.ori==0?1:-1),Q=w.ori==0?Zl:cf,st=w.ori==0?h:(It,Zt,ae,St,ke,Gt,Kt)=>{h(It,Zt,ae,ke,St,Kt,Gt)},ft=Ae(f.bands,ef).find(It=>It.series[0]==p),dt=ft!=null?ft.dir:0,tt=m.fillTo(f,p,m.min,m.max,dt),gt=G(y(tt,R,P,U)),yt,Rt,Mt,qt=N,oe=G(m.width*Ce),Wt=!1,fe=null,he=null,se=null,Je=null;u!=null&&(oe==0||d!=null)&&(Wt=!0,fe=u.values(f,p,x,g),he=new Map,new Set(fe).forEach(It=>{It!=null&&he.set(It,new Path2D)}),oe>0&&(se=d.values(f,p,x,g),Je=new Map,new Set(se).forEach(It=>{It!=null&&Je.set(It,new Path2D)})));let{x0:Ve,size:mn}=c;if(Ve!=null&&mn!=null){W=1,v=Ve.values(f,p,x,g),Ve.unit==2&&(v=v.map(ae=>f.posToVal(A+ae*N,w.key,!0)));let It=mn.values(f,p,x,g);mn.unit==2?Rt=It[0]*N:Rt=T(It[0],w,N,A)-T(0,w,N,A),qt=Gg(v,M,T,w,N,A,qt),Mt=qt-Rt+D}else qt=Gg(v,M,T,w,N,A,qt),Mt=qt*o+D,Rt=qt-Mt;Mt<1&&(Mt=0),oe>=Rt/2&&(oe=0),Mt<5&&(G=jg);let Oe=Mt>0,Ln=qt-Mt-(Oe?oe:0);Rt=G(Gd(Ln,$,V)),yt=(W==0?Rt/2:W==K?0:Rt)-W*K*((W==0?D/2:0)+(Oe?oe/2:0));let Se={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Sn=Wt?null:new Path2D,on=null;if(ft!=null)on=f.data[ft.series[1]];else{let{y0:It,y1:Zt}=c;It!=null&&Zt!=null&&(M=Zt.values(f,p,x,g),on=It.values(f,p,x,g))}let gn=k*Rt,F=ot*Rt;for(let It=K==1?x:g;It>=x&&It<=g;It+=K){let Zt=M[It];if(Zt==null)continue;if(on!=null){let X=on[It]??0;if(Zt-X==0)continue;gt=y(X,R,P,U)}let ae=w.distr!=2||c!=null?v[It]:It,St=T(ae,w,N,A),ke=y(Ae(Zt,tt),R,P,U),Gt=G(St-yt),Kt=G(Qn(ke,gt)),C=G(Oi(ke,gt)),b=Kt-C;if(Zt!=null){let X=Zt<0?F:gn,ut=Zt<0?gn:F;Wt?(oe>0&&se[It]!=null&&Q(Je.get(se[It]),Gt,C+ci(oe/2),Rt,Qn(0,b-oe),X,ut),fe[It]!=null&&Q(he.get(fe[It]),Gt,C+ci(oe/2),Rt,Qn(0,b-oe),X,ut)):Q(Sn,Gt,C+ci(oe/2),Rt,Qn(0,b-oe),X,ut),st(f,p,It,Gt-oe/2,C,Rt+oe,b)}}return oe>0?Se.stroke=Wt?Je:Sn:Wt||(Se._fill=m.width==0?m._fill:m._stroke??m._fill,Se.width=0),Se.fill=Wt?he:Sn,Se})}function wM(i,t){let e=Ae(t?.alignGaps,0);return(n,s,r,o)=>br(n,s,(a,l,c,h,u,d,f,p,x,g,m)=>{[r,o]=Gl(c,r,o);let v=a.pxRound,M=k=>v(d(k,h,g,p)),w=k=>v(f(k,u,m,x)),R,T,y;h.ori==0?(R=Yl,y=mo,T=E0):(R=Kl,y=go,T=T0);let A=h.dir*(h.ori==0?1:-1),U=M(l[A==1?r:o]),N=U,P=[],G=[];for(let k=A==1?r:o;k>=r&&k<=o;k+=A)if(c[k]!=null){let K=l[k],Q=M(K);P.push(N=Q),G.push(w(c[k]))}let W={stroke:i(P,G,R,y,T,v),fill:null,clip:null,band:null,gaps:null,flags:fo},D=W.stroke,[V,$]=af(n,s);if(a.fill!=null||V!=0){let k=W.fill=new Path2D(D),ot=a.fillTo(n,s,a.min,a.max,V),K=w(ot);y(k,N,K),y(k,U,K)}if(!a.spanGaps){let k=[];k.push(...lf(l,c,r,o,A,M,e)),W.gaps=k=a.gaps(n,s,r,o,k),W.clip=ql(k,h.ori,p,x,g,m)}return $!=0&&(W.band=$==2?[ys(n,s,r,o,D,-1),ys(n,s,r,o,D,1)]:ys(n,s,r,o,D,$)),W})}function bM(i){return wM(MM,i)}function MM(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=t[d+1]-t[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,t[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,t[d+1]-l[d+1]*u[d]/3,i[d+1],t[d+1])}return a}var qd=new Set;function Wg(){for(let i of qd)i.syncRect(!0)}po&&(_r(ib,lo,Wg),_r(sb,lo,Wg,!0),_r(zl,lo,()=>{un.pxRatio=Ce}));var SM=C0(),EM=A0();function $g(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Yd(r,o,t,e))}function TM(i,t){return i.map((e,n)=>n==0?{}:bn({},t,e))}function Yd(i,t,e,n){return bn({},t==0?e:n,i)}function I0(i,t,e){return t==null?ho:[t,e]}var AM=I0;function RM(i,t,e){return t==null?ho:Hl(t,e,Qd,!0)}function P0(i,t,e,n){return t==null?ho:Wl(t,e,i.scales[n].log,!1)}var CM=P0;function L0(i,t,e,n){return t==null?ho:jd(t,e,i.scales[n].log,!1)}var IM=L0;function PM(i,t,e,n,s){let r=Qn(Mg(i),Mg(t)),o=t-i,a=Di(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Vs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Xg(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=An((e=+s)*Ce))+"px"),[i,t,e]}function LM(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=He(t[2]*Ce,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function un(i,t,e){let n={mode:Ae(i.mode,1)},s=n.mode;function r(_,S,I,L){let H=S.valToPct(_);return L+I*(S.dir==-1?1-H:H)}function o(_,S,I,L){let H=S.valToPct(_);return L+I*(S.dir==-1?H:1-H)}function a(_,S,I,L){return S.ori==0?r(_,S,I,L):o(_,S,I,L)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Mi(Bw);if(i.id!=null&&(c.id=i.id),li(c,i.class),i.title){let _=Mi(Vw,c);_.textContent=i.title}let h=Ni("canvas"),u=n.ctx=h.getContext("2d"),d=Mi(Gw,c);_r("click",d,_=>{_.target===p&&(Xe!=Kr||je!=Zr)&&Bn.click(n,_)},!0);let f=n.under=Mi(Ww,d);d.appendChild(h);let p=n.over=Mi($w,d);i=uo(i);let x=+Ae(i.pxAlign,1),g=Vg(x);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let m=i.ms||.001,v=n.series=s==1?$g(i.series||[],Og,zg,!1):TM(i.series||[null],Bg),M=n.axes=$g(i.axes||[],Dg,Ug,!0),w=n.scales={},R=n.bands=i.bands||[];R.forEach(_=>{_.fill=ye(_.fill||null),_.dir=Ae(_.dir,-1)});let T=s==2?v[1].facets[0].scale:v[0].scale,y={axes:gs,series:me},A=(i.drawOrder||["axes","series"]).map(_=>y[_]);function U(_){let S=_.distr==3?I=>vs(I>0?I:_.clamp(n,I,_.min,_.max,_.key)):_.distr==4?I=>Od(I,_.asinh):_.distr==100?I=>_.fwd(I):I=>I;return I=>{let L=S(I),{_min:H,_max:Z}=_,ct=Z-H;return(L-H)/ct}}function N(_){let S=w[_];if(S==null){let I=(i.scales||_a)[_]||_a;if(I.from!=null){N(I.from);let L=bn({},w[I.from],I,{key:_});L.valToPct=U(L),w[_]=L}else{S=w[_]=bn({},_==T?_0:pM,I),S.key=_;let L=S.time,H=S.range,Z=Hs(H);if((_!=T||s==2&&!L)&&(Z&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?_g:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?_g:{mode:1,hard:H[1],soft:H[1]}},Z=!1),!Z&&Xl(H))){let ct=H;H=(pt,wt,Ot)=>wt==null?ho:Hl(wt,Ot,ct)}S.range=ye(H||(L?AM:_==T?S.distr==3?CM:S.distr==4?IM:I0:S.distr==3?P0:S.distr==4?L0:RM)),S.auto=ye(Z?!1:S.auto),S.clamp=ye(S.clamp||fM),S._min=S._max=null,S.valToPct=U(S)}}}N("x"),N("y"),s==1&&v.forEach(_=>{N(_.scale)}),M.forEach(_=>{N(_.scale)});for(let _ in i.scales)N(_);let P=w[T],G=P.distr,W,D;P.ori==0?(li(c,zw),W=r,D=o):(li(c,Hw),W=o,D=r);let V={};for(let _ in w){let S=w[_];(S.min!=null||S.max!=null)&&(V[_]={min:S.min,max:S.max},S.min=S.max=null)}let $=i.tzDate||(_=>new Date(An(_/m))),k=i.fmtDate||nf,ot=m==1?zb($):Gb($),K=Pg($,Ig(m==1?Bb:Vb,k)),Q=Ng($,Lg($b,k)),st=[],ft=n.legend=bn({},Yb,i.legend),dt=n.cursor=bn({},tM,{drag:{y:s==2}},i.cursor),tt=ft.show,gt=dt.show,yt=ft.markers;ft.idxs=st,yt.width=ye(yt.width),yt.dash=ye(yt.dash),yt.stroke=ye(yt.stroke),yt.fill=ye(yt.fill);let Rt,Mt,qt,oe=[],Wt=[],fe,he=!1,se={};if(ft.live){let _=v[1]?v[1].values:null;he=_!=null,fe=he?_(n,1,0):{_:0};for(let S in fe)se[S]=Zd}if(tt)if(Rt=Ni("table",Jw,c),qt=Ni("tbody",null,Rt),ft.mount(n,Rt),he){Mt=Ni("thead",null,Rt,qt);let _=Ni("tr",null,Mt);Ni("th",null,_);for(var Je in fe)Ni("th",ag,_).textContent=Je}else li(Rt,Qw),ft.live&&li(Rt,jw);let Ve={show:!0},mn={show:!1};function Oe(_,S){if(S==0&&(he||!ft.live||s==2))return ho;let I=[],L=Ni("tr",tb,qt,qt.childNodes[S]);li(L,_.class),_.show||li(L,yr);let H=Ni("th",null,L);if(yt.show){let pt=Mi(eb,H);if(S>0){let wt=yt.width(n,S);wt&&(pt.style.border=wt+"px "+yt.dash(n,S)+" "+yt.stroke(n,S)),pt.style.background=yt.fill(n,S)}}let Z=Mi(ag,H);_.label instanceof HTMLElement?Z.appendChild(_.label):Z.textContent=_.label,S>0&&(yt.show||(Z.style.color=_.width>0?yt.stroke(n,S):yt.fill(n,S)),Se("click",H,pt=>{if(dt._lock)return;Qt(pt);let wt=v.indexOf(_);if((pt.ctrlKey||pt.metaKey)!=ft.isolate){let Ot=v.some((Ft,kt)=>kt>0&&kt!=wt&&Ft.show);v.forEach((Ft,kt)=>{kt>0&&Ki(kt,Ot?kt==wt?Ve:mn:Ve,!0,_n.setSeries)})}else Ki(wt,{show:!_.show},!0,_n.setSeries)},!1),te&&Se(ug,H,pt=>{dt._lock||(Qt(pt),Ki(v.indexOf(_),jr,!0,_n.setSeries))},!1));for(var ct in fe){let pt=Ni("td",nb,L);pt.textContent="--",I.push(pt)}return[L,I]}let Ln=new Map;function Se(_,S,I,L=!0){let H=Ln.get(S)||{},Z=dt.bind[_](n,S,I,L);Z&&(_r(_,S,H[_]=Z),Ln.set(S,H))}function Sn(_,S,I){let L=Ln.get(S)||{};for(let H in L)(_==null||H==_)&&(Vd(H,S,L[H]),delete L[H]);_==null&&Ln.delete(S)}let on=0,gn=0,F=0,It=0,Zt=0,ae=0,St=Zt,ke=ae,Gt=F,Kt=It,C=0,b=0,X=0,ut=0;n.bbox={};let at=!1,vt=!1,_t=!1,et=!1,it=!1,mt=!1;function O(_,S,I){(I||_!=n.width||S!=n.height)&&rt(_,S),ue(!1),_t=!0,vt=!0,Gn()}function rt(_,S){n.width=on=F=_,n.height=gn=It=S,Zt=ae=0,bt(),Xt();let I=n.bbox;C=I.left=xr(Zt*Ce,.5),b=I.top=xr(ae*Ce,.5),X=I.width=xr(F*Ce,.5),ut=I.height=xr(It*Ce,.5)}let nt=3;function Et(){let _=!1,S=0;for(;!_;){S++;let I=Xr(S),L=Yi(S);_=S==nt||I&&L,_||(rt(n.width,n.height),vt=!0)}}function xt({width:_,height:S}){O(_,S)}n.setSize=xt;function bt(){let _=!1,S=!1,I=!1,L=!1;M.forEach((H,Z)=>{if(H.show&&H._show){let{side:ct,_size:pt}=H,wt=ct%2,Ot=H.label!=null?H.labelSize:0,Ft=pt+Ot;Ft>0&&(wt?(F-=Ft,ct==3?(Zt+=Ft,L=!0):I=!0):(It-=Ft,ct==0?(ae+=Ft,_=!0):S=!0))}}),Xi[0]=_,Xi[1]=I,Xi[2]=S,Xi[3]=L,F-=Ci[1]+Ci[3],Zt+=Ci[3],It-=Ci[2]+Ci[0],ae+=Ci[0]}function Xt(){let _=Zt+F,S=ae+It,I=Zt,L=ae;function H(Z,ct){switch(Z){case 1:return _+=ct,_-ct;case 2:return S+=ct,S-ct;case 3:return I-=ct,I+ct;case 0:return L-=ct,L+ct}}M.forEach((Z,ct)=>{if(Z.show&&Z._show){let pt=Z.side;Z._pos=H(pt,Z._size),Z.label!=null&&(Z._lpos=H(pt,Z.labelSize))}})}if(dt.dataIdx==null){let _=dt.hover,S=_.skip=new Set(_.skip??[]);S.add(void 0);let I=_.prox=ye(_.prox),L=_.bias??=0;dt.dataIdx=(H,Z,ct,pt)=>{if(Z==0)return ct;let wt=ct,Ot=I(H,Z,ct,pt)??ze,Ft=Ot>=0&&Ot<ze,kt=P.ori==0?F:It,re=dt.left,Re=t[0],Ee=t[Z];if(S.has(Ee[ct])){wt=null;let ge=null,Jt=null,Yt;if(L==0||L==-1)for(Yt=ct;ge==null&&Yt-- >0;)S.has(Ee[Yt])||(ge=Yt);if(L==0||L==1)for(Yt=ct;Jt==null&&Yt++<Ee.length;)S.has(Ee[Yt])||(Jt=Yt);if(ge!=null||Jt!=null)if(Ft){let Ye=ge==null?-1/0:W(Re[ge],P,kt,0),cn=Jt==null?1/0:W(Re[Jt],P,kt,0),Fn=re-Ye,Fe=cn-re;Fn<=Fe?Fn<=Ot&&(wt=ge):Fe<=Ot&&(wt=Jt)}else wt=Jt==null?ge:ge==null?Jt:ct-ge<=Jt-ct?ge:Jt}else Ft&&Rn(re-W(Re[ct],P,kt,0))>Ot&&(wt=null);return wt}}let Qt=_=>{dt.event=_};dt.idxs=st,dt._lock=!1;let ht=dt.points;ht.show=ye(ht.show),ht.size=ye(ht.size),ht.stroke=ye(ht.stroke),ht.width=ye(ht.width),ht.fill=ye(ht.fill);let Bt=n.focus=bn({},i.focus||{alpha:.3},dt.focus),te=Bt.prox>=0,Ct=te&&ht.one,le=[],$e=[],Yn=[];function ia(_,S){let I=ht.show(n,S);if(I instanceof HTMLElement)return li(I,Zw),li(I,_.class),es(I,-10,-10,F,It),p.insertBefore(I,le[S]),I}function Gr(_,S){if(s==1||S>0){let I=s==1&&w[_.scale].time,L=_.value;_.value=I?Tg(L)?Ng($,Lg(L,k)):L||Q:L||hM,_.label=_.label||(I?nM:eM)}if(Ct||S>0){_.width=_.width==null?1:_.width,_.paths=_.paths||SM||pb,_.fillTo=ye(_.fillTo||mM),_.pxAlign=+Ae(_.pxAlign,x),_.pxRound=Vg(_.pxAlign),_.stroke=ye(_.stroke||null),_.fill=ye(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let I=uM(Qn(1,_.width),1),L=_.points=bn({},{size:I,width:Qn(1,I*.2),stroke:_.stroke,space:I*2,paths:EM,_stroke:null,_fill:null},_.points);L.show=ye(L.show),L.filter=ye(L.filter),L.fill=ye(L.fill),L.stroke=ye(L.stroke),L.paths=ye(L.paths),L.pxAlign=_.pxAlign}if(tt){let I=Oe(_,S);oe.splice(S,0,I[0]),Wt.splice(S,0,I[1]),ft.values.push(null)}if(gt){st.splice(S,0,null);let I=null;Ct?S==0&&(I=ia(_,S)):S>0&&(I=ia(_,S)),le.splice(S,0,I),$e.splice(S,0,0),Yn.splice(S,0,0)}On("addSeries",S)}function cd(_,S){S=S??v.length,_=s==1?Yd(_,S,Og,zg):Yd(_,S,{},Bg),v.splice(S,0,_),Gr(v[S],S)}n.addSeries=cd;function yl(_){if(v.splice(_,1),tt){ft.values.splice(_,1),Wt.splice(_,1);let S=oe.splice(_,1)[0];Sn(null,S.firstChild),S.remove()}gt&&(st.splice(_,1),le.splice(_,1)[0].remove(),$e.splice(_,1),Yn.splice(_,1)),On("delSeries",_)}n.delSeries=yl;let Xi=[!1,!1,!1,!1];function fs(_,S){if(_._show=_.show,_.show){let I=_.side%2,L=w[_.scale];L==null&&(_.scale=I?v[1].scale:T,L=w[_.scale]);let H=L.time;_.size=ye(_.size),_.space=ye(_.space),_.rotate=ye(_.rotate),Hs(_.incrs)&&_.incrs.forEach(ct=>{!Vs.has(ct)&&Vs.set(ct,e0(ct))}),_.incrs=ye(_.incrs||(L.distr==2?Fb:H?m==1?kb:Hb:vr)),_.splits=ye(_.splits||(H&&L.distr==1?ot:L.distr==3?Wd:L.distr==4?rM:sM)),_.stroke=ye(_.stroke),_.grid.stroke=ye(_.grid.stroke),_.ticks.stroke=ye(_.ticks.stroke),_.border.stroke=ye(_.border.stroke);let Z=_.values;_.values=Hs(Z)&&!Hs(Z[0])?ye(Z):H?Hs(Z)?Pg($,Ig(Z,k)):Tg(Z)?Wb($,Z):Z||K:Z||iM,_.filter=ye(_.filter||(L.distr>=3&&L.log==10?lM:L.distr==3&&L.log==2?cM:Qg)),_.font=Xg(_.font),_.labelFont=Xg(_.labelFont),_._size=_.size(n,null,S,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Xi[S]=!0,_._el=Mi(Xw,d))}}function ps(_,S,I,L){let[H,Z,ct,pt]=I,wt=S%2,Ot=0;return wt==0&&(pt||Z)&&(Ot=S==0&&!H||S==2&&!ct?An(Dg.size/3):0),wt==1&&(H||ct)&&(Ot=S==1&&!Z||S==3&&!pt?An(Ug.size/2):0),Ot}let sa=n.padding=(i.padding||[ps,ps,ps,ps]).map(_=>ye(Ae(_,ps))),Ci=n._padding=sa.map((_,S)=>_(n,S,Xi,0)),an,dn=null,fn=null,qi=s==1?v[0].idxs:null,si=null,Ns=!1;function ra(_,S){if(t=_??[],n.data=n._data=t,s==2){an=0;for(let I=1;I<v.length;I++)an+=t[I][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),si=t[0],an=si.length;let I=t;if(G==2){I=t.slice();let L=I[0]=Array(an);for(let H=0;H<an;H++)L[H]=H}n._data=t=I}if(ue(!0),On("setData"),G==2&&(_t=!0),S!==!1){let I=P;I.auto(n,Ns)?oa():Fs(T,I.min,I.max),et=et||dt.left>=0,mt=!0,Gn()}}n.setData=ra;function oa(){Ns=!0;let _,S;s==1&&(an>0?(dn=qi[0]=0,fn=qi[1]=an-1,_=t[0][dn],S=t[0][fn],G==2?(_=dn,S=fn):_==S&&(G==3?[_,S]=Wl(_,_,P.log,!1):G==4?[_,S]=jd(_,_,P.log,!1):P.time?S=_+An(86400/m):[_,S]=Hl(_,S,Qd,!0))):(dn=qi[0]=_=null,fn=qi[1]=S=null)),Fs(T,_,S)}let Wr,Ds,$r,E,B,j,q,Y,Tt,Pt;function At(_,S,I,L,H,Z){_??=cg,I??=ef,L??="butt",H??=cg,Z??="round",_!=Wr&&(u.strokeStyle=Wr=_),H!=Ds&&(u.fillStyle=Ds=H),S!=$r&&(u.lineWidth=$r=S),Z!=B&&(u.lineJoin=B=Z),L!=j&&(u.lineCap=j=L),I!=E&&u.setLineDash(E=I)}function Lt(_,S,I,L){S!=Ds&&(u.fillStyle=Ds=S),_!=q&&(u.font=q=_),I!=Y&&(u.textAlign=Y=I),L!=Tt&&(u.textBaseline=Tt=L)}function Vt(_,S,I,L,H=0){if(L.length>0&&_.auto(n,Ns)&&(S==null||S.min==null)){let Z=Ae(dn,0),ct=Ae(fn,L.length-1),pt=I.min==null?lb(L,Z,ct,H,_.distr==3):[I.min,I.max];_.min=Oi(_.min,I.min=pt[0]),_.max=Qn(_.max,I.max=pt[1])}}let ee={min:null,max:null};function pe(){for(let L in w){let H=w[L];V[L]==null&&(H.min==null||V[T]!=null&&H.auto(n,Ns))&&(V[L]=ee)}for(let L in w){let H=w[L];V[L]==null&&H.from!=null&&V[H.from]!=null&&(V[L]=ee)}V[T]!=null&&ue(!0);let _={};for(let L in V){let H=V[L];if(H!=null){let Z=_[L]=uo(w[L],xb);if(H.min!=null)bn(Z,H);else if(L!=T||s==2)if(an==0&&Z.from==null){let ct=Z.range(n,null,null,L);Z.min=ct[0],Z.max=ct[1]}else Z.min=ze,Z.max=-ze}}if(an>0){v.forEach((L,H)=>{if(s==1){let Z=L.scale,ct=V[Z];if(ct==null)return;let pt=_[Z];if(H==0){let wt=pt.range(n,pt.min,pt.max,Z);pt.min=wt[0],pt.max=wt[1],dn=Di(pt.min,t[0]),fn=Di(pt.max,t[0]),fn-dn>1&&(t[0][dn]<pt.min&&dn++,t[0][fn]>pt.max&&fn--),L.min=si[dn],L.max=si[fn]}else L.show&&L.auto&&Vt(pt,ct,L,t[H],L.sorted);L.idxs[0]=dn,L.idxs[1]=fn}else if(H>0&&L.show&&L.auto){let[Z,ct]=L.facets,pt=Z.scale,wt=ct.scale,[Ot,Ft]=t[H],kt=_[pt],re=_[wt];kt!=null&&Vt(kt,V[pt],Z,Ot,Z.sorted),re!=null&&Vt(re,V[wt],ct,Ft,ct.sorted),L.min=ct.min,L.max=ct.max}});for(let L in _){let H=_[L],Z=V[L];if(H.from==null&&(Z==null||Z.min==null)){let ct=H.range(n,H.min==ze?null:H.min,H.max==-ze?null:H.max,L);H.min=ct[0],H.max=ct[1]}}}for(let L in _){let H=_[L];if(H.from!=null){let Z=_[H.from];if(Z.min==null)H.min=H.max=null;else{let ct=H.range(n,Z.min,Z.max,L);H.min=ct[0],H.max=ct[1]}}}let S={},I=!1;for(let L in _){let H=_[L],Z=w[L];if(Z.min!=H.min||Z.max!=H.max){Z.min=H.min,Z.max=H.max;let ct=Z.distr;Z._min=ct==3?vs(Z.min):ct==4?Od(Z.min,Z.asinh):ct==100?Z.fwd(Z.min):Z.min,Z._max=ct==3?vs(Z.max):ct==4?Od(Z.max,Z.asinh):ct==100?Z.fwd(Z.max):Z.max,S[L]=I=!0}}if(I){v.forEach((L,H)=>{s==2?H>0&&S.y&&(L._paths=null):S[L.scale]&&(L._paths=null)});for(let L in S)_t=!0,On("setScale",L);gt&&dt.left>=0&&(et=mt=!0)}for(let L in V)V[L]=null}function zt(_){let S=Gd(dn-1,0,an-1),I=Gd(fn+1,0,an-1);for(;_[S]==null&&S>0;)S--;for(;_[I]==null&&I<an-1;)I++;return[S,I]}function me(){if(an>0){let _=v.some(S=>S._focus)&&Pt!=Bt.alpha;_&&(u.globalAlpha=Pt=Bt.alpha),v.forEach((S,I)=>{if(I>0&&S.show&&(sn(I,!1),sn(I,!0),S._paths==null)){let L=Pt;Pt!=S.alpha&&(u.globalAlpha=Pt=S.alpha);let H=s==2?[0,t[I][0].length-1]:zt(t[I]);S._paths=S.paths(n,I,H[0],H[1]),Pt!=L&&(u.globalAlpha=Pt=L)}}),v.forEach((S,I)=>{if(I>0&&S.show){let L=Pt;Pt!=S.alpha&&(u.globalAlpha=Pt=S.alpha),S._paths!=null&&Le(I,!1);{let H=S._paths!=null?S._paths.gaps:null,Z=S.points.show(n,I,dn,fn,H),ct=S.points.filter(n,I,Z,H);(Z||ct)&&(S.points._paths=S.points.paths(n,I,dn,fn,ct),Le(I,!0))}Pt!=L&&(u.globalAlpha=Pt=L),On("drawSeries",I)}}),_&&(u.globalAlpha=Pt=1)}}function sn(_,S){let I=S?v[_].points:v[_];I._stroke=I.stroke(n,_),I._fill=I.fill(n,_)}function Le(_,S){let I=S?v[_].points:v[_],{stroke:L,fill:H,clip:Z,flags:ct,_stroke:pt=I._stroke,_fill:wt=I._fill,_width:Ot=I.width}=I._paths;Ot=He(Ot*Ce,3);let Ft=null,kt=Ot%2/2;S&&wt==null&&(wt=Ot>0?"#fff":pt);let re=I.pxAlign==1&&kt>0;if(re&&u.translate(kt,kt),!S){let Re=C-Ot/2,Ee=b-Ot/2,ge=X+Ot,Jt=ut+Ot;Ft=new Path2D,Ft.rect(Re,Ee,ge,Jt)}S?Ut(pt,Ot,I.dash,I.cap,wt,L,H,ct,Z):Ne(_,pt,Ot,I.dash,I.cap,wt,L,H,ct,Ft,Z),re&&u.translate(-kt,-kt)}function Ne(_,S,I,L,H,Z,ct,pt,wt,Ot,Ft){let kt=!1;wt!=0&&R.forEach((re,Re)=>{if(re.series[0]==_){let Ee=v[re.series[1]],ge=t[re.series[1]],Jt=(Ee._paths||_a).band;Hs(Jt)&&(Jt=re.dir==1?Jt[0]:Jt[1]);let Yt,Ye=null;Ee.show&&Jt&&hb(ge,dn,fn)?(Ye=re.fill(n,Re)||Z,Yt=Ee._paths.clip):Jt=null,Ut(S,I,L,H,Ye,ct,pt,wt,Ot,Ft,Yt,Jt),kt=!0}}),kt||Ut(S,I,L,H,Z,ct,pt,wt,Ot,Ft)}let En=fo|Xd;function Ut(_,S,I,L,H,Z,ct,pt,wt,Ot,Ft,kt){At(_,S,I,L,H),(wt||Ot||kt)&&(u.save(),wt&&u.clip(wt),Ot&&u.clip(Ot)),kt?(pt&En)==En?(u.clip(kt),Ft&&u.clip(Ft),ve(H,ct),xn(_,Z,S)):pt&Xd?(ve(H,ct),u.clip(kt),xn(_,Z,S)):pt&fo&&(u.save(),u.clip(kt),Ft&&u.clip(Ft),ve(H,ct),u.restore(),xn(_,Z,S)):(ve(H,ct),xn(_,Z,S)),(wt||Ot||kt)&&u.restore()}function xn(_,S,I){I>0&&(S instanceof Map?S.forEach((L,H)=>{u.strokeStyle=Wr=H,u.stroke(L)}):S!=null&&_&&u.stroke(S))}function ve(_,S){S instanceof Map?S.forEach((I,L)=>{u.fillStyle=Ds=L,u.fill(I)}):S!=null&&_&&u.fill(S)}function ms(_,S,I,L){let H=M[_],Z;if(L<=0)Z=[0,0];else{let ct=H._space=H.space(n,_,S,I,L),pt=H._incrs=H.incrs(n,_,S,I,L,ct);Z=PM(S,I,pt,L,ct)}return H._found=Z}function vn(_,S,I,L,H,Z,ct,pt,wt,Ot){let Ft=ct%2/2;x==1&&u.translate(Ft,Ft),At(pt,ct,wt,Ot,pt),u.beginPath();let kt,re,Re,Ee,ge=H+(L==0||L==3?-Z:Z);I==0?(re=H,Ee=ge):(kt=H,Re=ge);for(let Jt=0;Jt<_.length;Jt++)S[Jt]!=null&&(I==0?kt=Re=_[Jt]:re=Ee=_[Jt],u.moveTo(kt,re),u.lineTo(Re,Ee));u.stroke(),x==1&&u.translate(-Ft,-Ft)}function Xr(_){let S=!0;return M.forEach((I,L)=>{if(!I.show)return;let H=w[I.scale];if(H.min==null){I._show&&(S=!1,I._show=!1,ue(!1));return}else I._show||(S=!1,I._show=!0,ue(!1));let Z=I.side,ct=Z%2,{min:pt,max:wt}=H,[Ot,Ft]=ms(L,pt,wt,ct==0?F:It);if(Ft==0)return;let kt=H.distr==2,re=I._splits=I.splits(n,L,pt,wt,Ot,Ft,kt),Re=H.distr==2?re.map(Yt=>si[Yt]):re,Ee=H.distr==2?si[re[1]]-si[re[0]]:Ot,ge=I._values=I.values(n,I.filter(n,Re,L,Ft,Ee),L,Ft,Ee);I._rotate=Z==2?I.rotate(n,ge,L,Ft):0;let Jt=I._size;I._size=Si(I.size(n,ge,L,_)),Jt!=null&&I._size!=Jt&&(S=!1)}),S}function Yi(_){let S=!0;return sa.forEach((I,L)=>{let H=I(n,L,Xi,_);H!=Ci[L]&&(S=!1),Ci[L]=H}),S}function gs(){for(let _=0;_<M.length;_++){let S=M[_];if(!S.show||!S._show)continue;let I=S.side,L=I%2,H,Z,ct=S.stroke(n,_),pt=I==0||I==3?-1:1,[wt,Ot]=S._found;if(S.label!=null){let Jn=S.labelGap*pt,ai=An((S._lpos+Jn)*Ce);Lt(S.labelFont[0],ct,"center",I==2?"top":lg),u.save(),L==1?(H=Z=0,u.translate(ai,An(b+ut/2)),u.rotate((I==3?-Bl:Bl)/2)):(H=An(C+X/2),Z=ai);let hr=Jg(S.label)?S.label(n,_,wt,Ot):S.label;u.fillText(hr,H,Z),u.restore()}if(Ot==0)continue;let Ft=w[S.scale],kt=L==0?X:ut,re=L==0?C:b,Re=S._splits,Ee=Ft.distr==2?Re.map(Jn=>si[Jn]):Re,ge=Ft.distr==2?si[Re[1]]-si[Re[0]]:wt,Jt=S.ticks,Yt=S.border,Ye=Jt.show?Jt.size:0,cn=An(Ye*Ce),Fn=An((S.alignTo==2?S._size-Ye-S.gap:S.gap)*Ce),Fe=S._rotate*-Bl/180,hn=g(S._pos*Ce),ri=(cn+Fn)*pt,Zn=hn+ri;Z=L==0?Zn:0,H=L==1?Zn:0;let yi=S.font[0],Ii=S.align==1?oo:S.align==2?Ld:Fe>0?oo:Fe<0?Ld:L==0?"center":I==3?Ld:oo,Ji=Fe||L==1?"middle":I==2?"top":lg;Lt(yi,ct,Ii,Ji);let oi=S.font[1]*S.lineGap,_i=Re.map(Jn=>g(a(Jn,Ft,kt,re))),Pi=S._values;for(let Jn=0;Jn<Pi.length;Jn++){let ai=Pi[Jn];if(ai!=null){L==0?H=_i[Jn]:Z=_i[Jn],ai=""+ai;let hr=ai.indexOf(`
`)==-1?[ai]:ai.split(/\n/gm);for(let jn=0;jn<hr.length;jn++){let Fm=hr[jn];Fe?(u.save(),u.translate(H,Z+jn*oi),u.rotate(Fe),u.fillText(Fm,0,0),u.restore()):u.fillText(Fm,H,Z+jn*oi)}}}Jt.show&&vn(_i,Jt.filter(n,Ee,_,Ot,ge),L,I,hn,cn,He(Jt.width*Ce,3),Jt.stroke(n,_),Jt.dash,Jt.cap);let ji=S.grid;ji.show&&vn(_i,ji.filter(n,Ee,_,Ot,ge),L,L==0?2:1,L==0?b:C,L==0?ut:X,He(ji.width*Ce,3),ji.stroke(n,_),ji.dash,ji.cap),Yt.show&&vn([hn],[1],L==0?1:0,L==0?1:2,L==1?b:C,L==1?ut:X,He(Yt.width*Ce,3),Yt.stroke(n,_),Yt.dash,Yt.cap)}On("drawAxes")}function ue(_){v.forEach((S,I)=>{I>0&&(S._paths=null,_&&(s==1?(S.min=null,S.max=null):S.facets.forEach(L=>{L.min=null,L.max=null})))})}let ln=!1,Kn=!1,De=[];function yn(){Kn=!1;for(let _=0;_<De.length;_++)On(...De[_]);De.length=0}function Gn(){ln||(Sb(vm),ln=!0)}function _l(_,S=!1){ln=!0,Kn=S,_(n),vm(),S&&De.length>0&&queueMicrotask(yn)}n.batch=_l;function vm(){if(at&&(pe(),at=!1),_t&&(Et(),_t=!1),vt){if(Ke(f,oo,Zt),Ke(f,"top",ae),Ke(f,ga,F),Ke(f,xa,It),Ke(p,oo,Zt),Ke(p,"top",ae),Ke(p,ga,F),Ke(p,xa,It),Ke(d,ga,on),Ke(d,xa,gn),h.width=An(on*Ce),h.height=An(gn*Ce),M.forEach(({_el:_,_show:S,_size:I,_pos:L,side:H})=>{if(_!=null)if(S){let Z=H===3||H===0?I:0,ct=H%2==1;Ke(_,ct?"left":"top",L-Z),Ke(_,ct?"width":"height",I),Ke(_,ct?"top":"left",ct?ae:Zt),Ke(_,ct?"height":"width",ct?It:F),Hd(_,yr)}else li(_,yr)}),Wr=Ds=$r=B=j=q=Y=Tt=E=null,Pt=1,ca(!0),Zt!=St||ae!=ke||F!=Gt||It!=Kt){ue(!1);let _=F/Gt,S=It/Kt;if(gt&&!et&&dt.left>=0){dt.left*=_,dt.top*=S,qr&&es(qr,An(dt.left),0,F,It),Yr&&es(Yr,0,An(dt.top),F,It);for(let I=0;I<le.length;I++){let L=le[I];L!=null&&($e[I]*=_,Yn[I]*=S,es(L,Si($e[I]),Si(Yn[I]),F,It))}}if(qe.show&&!it&&qe.left>=0&&qe.width>0){qe.left*=_,qe.width*=_,qe.top*=S,qe.height*=S;for(let I in md)Ke(Jr,I,qe[I])}St=Zt,ke=ae,Gt=F,Kt=It}On("setSize"),vt=!1}on>0&&gn>0&&(u.clearRect(0,0,h.width,h.height),On("drawClear"),A.forEach(_=>_()),On("draw")),qe.show&&it&&(wl(qe),it=!1),gt&&et&&(cr(null,!0,!1),et=!1),ft.show&&ft.live&&mt&&(fd(),mt=!1),l||(l=!0,n.status=1,On("ready")),Ns=!1,ln=!1}n.redraw=(_,S)=>{_t=S||!1,_!==!1?Fs(T,P.min,P.max):Gn()};function hd(_,S){let I=w[_];if(I.from==null){if(an==0){let L=I.range(n,S.min,S.max,_);S.min=L[0],S.max=L[1]}if(S.min>S.max){let L=S.min;S.min=S.max,S.max=L}if(an>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;_==T&&I.distr==2&&an>0&&(S.min=Di(S.min,t[0]),S.max=Di(S.max,t[0]),S.min==S.max&&S.max++),V[_]=S,at=!0,Gn()}}n.setScale=hd;let ud,dd,qr,Yr,ym,_m,Kr,Zr,wm,bm,Xe,je,Os=!1,Bn=dt.drag,Nn=Bn.x,Dn=Bn.y;gt&&(dt.x&&(ud=Mi(Yw,p)),dt.y&&(dd=Mi(Kw,p)),P.ori==0?(qr=ud,Yr=dd):(qr=dd,Yr=ud),Xe=dt.left,je=dt.top);let qe=n.select=bn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Jr=qe.show?Mi(qw,qe.over?p:f):null;function wl(_,S){if(qe.show){for(let I in _)qe[I]=_[I],I in md&&Ke(Jr,I,_[I]);S!==!1&&On("setSelect")}}n.setSelect=wl;function D_(_){if(v[_].show)tt&&Hd(oe[_],yr);else if(tt&&li(oe[_],yr),gt){let I=Ct?le[0]:le[_];I!=null&&es(I,-10,-10,F,It)}}function Fs(_,S,I){hd(_,{min:S,max:I})}function Ki(_,S,I,L){S.focus!=null&&B_(_),S.show!=null&&v.forEach((H,Z)=>{Z>0&&(_==Z||_==null)&&(H.show=S.show,D_(Z),s==2?(Fs(H.facets[0].scale,null,null),Fs(H.facets[1].scale,null,null)):Fs(H.scale,null,null),Gn())}),I!==!1&&On("setSeries",_,S),L&&ha("setSeries",n,_,S)}n.setSeries=Ki;function O_(_,S){bn(R[_],S)}function F_(_,S){_.fill=ye(_.fill||null),_.dir=Ae(_.dir,-1),S=S??R.length,R.splice(S,0,_)}function U_(_){_==null?R.length=0:R.splice(_,1)}n.addBand=F_,n.setBand=O_,n.delBand=U_;function k_(_,S){v[_].alpha=S,gt&&le[_]!=null&&(le[_].style.opacity=S),tt&&oe[_]&&(oe[_].style.opacity=S)}let xs,Us,lr,jr={focus:!0};function B_(_){if(_!=lr){let S=_==null,I=Bt.alpha!=1;v.forEach((L,H)=>{if(s==1||H>0){let Z=S||H==0||H==_;L._focus=S?null:Z,I&&k_(H,Z?1:Bt.alpha)}}),lr=_,I&&Gn()}}tt&&te&&Se(dg,Rt,_=>{dt._lock||(Qt(_),lr!=null&&Ki(null,jr,!0,_n.setSeries))});function Zi(_,S,I){let L=w[S];I&&(_=_/Ce-(L.ori==1?ae:Zt));let H=F;L.ori==1&&(H=It,_=H-_),L.dir==-1&&(_=H-_);let Z=L._min,ct=L._max,pt=_/H,wt=Z+(ct-Z)*pt,Ot=L.distr;return Ot==3?co(10,wt):Ot==4?db(wt,L.asinh):Ot==100?L.bwd(wt):wt}function z_(_,S){let I=Zi(_,T,S);return Di(I,t[0],dn,fn)}n.valToIdx=_=>Di(_,t[0]),n.posToIdx=z_,n.posToVal=Zi,n.valToPos=(_,S,I)=>w[S].ori==0?r(_,w[S],I?X:F,I?C:0):o(_,w[S],I?ut:It,I?b:0),n.setCursor=(_,S,I)=>{Xe=_.left,je=_.top,cr(null,S,I)};function Mm(_,S){Ke(Jr,oo,qe.left=_),Ke(Jr,ga,qe.width=S)}function Sm(_,S){Ke(Jr,"top",qe.top=_),Ke(Jr,xa,qe.height=S)}let aa=P.ori==0?Mm:Sm,la=P.ori==1?Mm:Sm;function H_(){if(tt&&ft.live)for(let _=s==2?1:0;_<v.length;_++){if(_==0&&he)continue;let S=ft.values[_],I=0;for(let L in S)Wt[_][I++].firstChild.nodeValue=S[L]}}function fd(_,S){if(_!=null&&(_.idxs?_.idxs.forEach((I,L)=>{st[L]=I}):gb(_.idx)||st.fill(_.idx),ft.idx=st[0]),tt&&ft.live){for(let I=0;I<v.length;I++)(I>0||s==1&&!he)&&V_(I,st[I]);H_()}mt=!1,S!==!1&&On("setLegend")}n.setLegend=fd;function V_(_,S){let I=v[_],L=_==0&&G==2?si:t[_],H;he?H=I.values(n,_,S)??se:(H=I.value(n,S==null?null:L[S],_,S),H=H==null?se:{_:H}),ft.values[_]=H}function cr(_,S,I){wm=Xe,bm=je,[Xe,je]=dt.move(n,Xe,je),dt.left=Xe,dt.top=je,gt&&(qr&&es(qr,An(Xe),0,F,It),Yr&&es(Yr,0,An(je),F,It));let L,H=dn>fn;xs=ze,Us=null;let Z=P.ori==0?F:It,ct=P.ori==1?F:It;if(Xe<0||an==0||H){L=dt.idx=null;for(let pt=0;pt<v.length;pt++){let wt=le[pt];wt!=null&&es(wt,-10,-10,F,It)}te&&Ki(null,jr,!0,_==null&&_n.setSeries),ft.live&&(st.fill(L),mt=!0)}else{let pt,wt,Ot;s==1&&(pt=P.ori==0?Xe:je,wt=Zi(pt,T),L=dt.idx=Di(wt,t[0],dn,fn),Ot=W(t[0][L],P,Z,0));let Ft=-10,kt=-10,re=0,Re=0,Ee=!0,ge="",Jt="";for(let Yt=s==2?1:0;Yt<v.length;Yt++){let Ye=v[Yt],cn=st[Yt],Fn=cn==null?null:s==1?t[Yt][cn]:t[Yt][1][cn],Fe=dt.dataIdx(n,Yt,L,wt),hn=Fe==null?null:s==1?t[Yt][Fe]:t[Yt][1][Fe];if(mt=mt||hn!=Fn||Fe!=cn,st[Yt]=Fe,Yt>0&&Ye.show){let ri=Fe==null?-10:Fe==L?Ot:W(s==1?t[0][Fe]:t[Yt][0][Fe],P,Z,0),Zn=hn==null?-10:D(hn,s==1?w[Ye.scale]:w[Ye.facets[1].scale],ct,0);if(te&&hn!=null){let yi=P.ori==1?Xe:je,Ii=Rn(Bt.dist(n,Yt,Fe,Zn,yi));if(Ii<xs){let Ji=Bt.bias;if(Ji!=0){let oi=Zi(yi,Ye.scale),_i=hn>=0?1:-1,Pi=oi>=0?1:-1;Pi==_i&&(Pi==1?Ji==1?hn>=oi:hn<=oi:Ji==1?hn<=oi:hn>=oi)&&(xs=Ii,Us=Yt)}else xs=Ii,Us=Yt}}if(mt||Ct){let yi,Ii;P.ori==0?(yi=ri,Ii=Zn):(yi=Zn,Ii=ri);let Ji,oi,_i,Pi,ji,Jn,ai=!0,hr=ht.bbox;if(hr!=null){ai=!1;let jn=hr(n,Yt);_i=jn.left,Pi=jn.top,Ji=jn.width,oi=jn.height}else _i=yi,Pi=Ii,Ji=oi=ht.size(n,Yt);if(Jn=ht.fill(n,Yt),ji=ht.stroke(n,Yt),Ct)Yt==Us&&xs<=Bt.prox&&(Ft=_i,kt=Pi,re=Ji,Re=oi,Ee=ai,ge=Jn,Jt=ji);else{let jn=le[Yt];jn!=null&&($e[Yt]=_i,Yn[Yt]=Pi,yg(jn,Ji,oi,ai),xg(jn,Jn,ji),es(jn,Si(_i),Si(Pi),F,It))}}}}if(Ct){let Yt=Bt.prox,Ye=lr==null?xs<=Yt:xs>Yt||Us!=lr;if(mt||Ye){let cn=le[0];cn!=null&&($e[0]=Ft,Yn[0]=kt,yg(cn,re,Re,Ee),xg(cn,ge,Jt),es(cn,Si(Ft),Si(kt),F,It))}}}if(qe.show&&Os)if(_!=null){let[pt,wt]=_n.scales,[Ot,Ft]=_n.match,[kt,re]=_.cursor.sync.scales,Re=_.cursor.drag;if(Nn=Re._x,Dn=Re._y,Nn||Dn){let{left:Ee,top:ge,width:Jt,height:Yt}=_.select,Ye=_.scales[kt].ori,cn=_.posToVal,Fn,Fe,hn,ri,Zn,yi=pt!=null&&Ot(pt,kt),Ii=wt!=null&&Ft(wt,re);yi&&Nn?(Ye==0?(Fn=Ee,Fe=Jt):(Fn=ge,Fe=Yt),hn=w[pt],ri=W(cn(Fn,kt),hn,Z,0),Zn=W(cn(Fn+Fe,kt),hn,Z,0),aa(Oi(ri,Zn),Rn(Zn-ri))):aa(0,Z),Ii&&Dn?(Ye==1?(Fn=Ee,Fe=Jt):(Fn=ge,Fe=Yt),hn=w[wt],ri=D(cn(Fn,re),hn,ct,0),Zn=D(cn(Fn+Fe,re),hn,ct,0),la(Oi(ri,Zn),Rn(Zn-ri))):la(0,ct)}else gd()}else{let pt=Rn(wm-ym),wt=Rn(bm-_m);if(P.ori==1){let re=pt;pt=wt,wt=re}Nn=Bn.x&&pt>=Bn.dist,Dn=Bn.y&&wt>=Bn.dist;let Ot=Bn.uni;Ot!=null?Nn&&Dn&&(Nn=pt>=Ot,Dn=wt>=Ot,!Nn&&!Dn&&(wt>pt?Dn=!0:Nn=!0)):Bn.x&&Bn.y&&(Nn||Dn)&&(Nn=Dn=!0);let Ft,kt;Nn&&(P.ori==0?(Ft=Kr,kt=Xe):(Ft=Zr,kt=je),aa(Oi(Ft,kt),Rn(kt-Ft)),Dn||la(0,ct)),Dn&&(P.ori==1?(Ft=Kr,kt=Xe):(Ft=Zr,kt=je),la(Oi(Ft,kt),Rn(kt-Ft)),Nn||aa(0,Z)),!Nn&&!Dn&&(aa(0,0),la(0,0))}if(Bn._x=Nn,Bn._y=Dn,_==null){if(I){if(Om!=null){let[pt,wt]=_n.scales;_n.values[0]=pt!=null?Zi(P.ori==0?Xe:je,pt):null,_n.values[1]=wt!=null?Zi(P.ori==1?Xe:je,wt):null}ha(Nd,n,Xe,je,F,It,L)}if(te){let pt=I&&_n.setSeries,wt=Bt.prox;lr==null?xs<=wt&&Ki(Us,jr,!0,pt):xs>wt?Ki(null,jr,!0,pt):Us!=lr&&Ki(Us,jr,!0,pt)}}mt&&(ft.idx=L,fd()),S!==!1&&On("setCursor")}let ks=null;Object.defineProperty(n,"rect",{get(){return ks==null&&ca(!1),ks}});function ca(_=!1){_?ks=null:(ks=p.getBoundingClientRect(),On("syncRect",ks))}function Em(_,S,I,L,H,Z,ct){dt._lock||Os&&_!=null&&_.movementX==0&&_.movementY==0||(pd(_,S,I,L,H,Z,ct,!1,_!=null),_!=null?cr(null,!0,!0):cr(S,!0,!1))}function pd(_,S,I,L,H,Z,ct,pt,wt){if(ks==null&&ca(!1),Qt(_),_!=null)I=_.clientX-ks.left,L=_.clientY-ks.top;else{if(I<0||L<0){Xe=-10,je=-10;return}let[Ot,Ft]=_n.scales,kt=S.cursor.sync,[re,Re]=kt.values,[Ee,ge]=kt.scales,[Jt,Yt]=_n.match,Ye=S.axes[0].side%2==1,cn=P.ori==0?F:It,Fn=P.ori==1?F:It,Fe=Ye?Z:H,hn=Ye?H:Z,ri=Ye?L:I,Zn=Ye?I:L;if(Ee!=null?I=Jt(Ot,Ee)?a(re,w[Ot],cn,0):-10:I=cn*(ri/Fe),ge!=null?L=Yt(Ft,ge)?a(Re,w[Ft],Fn,0):-10:L=Fn*(Zn/hn),P.ori==1){let yi=I;I=L,L=yi}}wt&&(S==null||S.cursor.event.type==Nd)&&((I<=1||I>=F-1)&&(I=xr(I,F)),(L<=1||L>=It-1)&&(L=xr(L,It))),pt?(ym=I,_m=L,[Kr,Zr]=dt.move(n,I,L)):(Xe=I,je=L)}let md={width:0,height:0,left:0,top:0};function gd(){wl(md,!1)}let Tm,Am,Rm,Cm;function Im(_,S,I,L,H,Z,ct){Os=!0,Nn=Dn=Bn._x=Bn._y=!1,pd(_,S,I,L,H,Z,ct,!0,!1),_!=null&&(Se(Dd,Bd,Pm,!1),ha(hg,n,Kr,Zr,F,It,null));let{left:pt,top:wt,width:Ot,height:Ft}=qe;Tm=pt,Am=wt,Rm=Ot,Cm=Ft}function Pm(_,S,I,L,H,Z,ct){Os=Bn._x=Bn._y=!1,pd(_,S,I,L,H,Z,ct,!1,!0);let{left:pt,top:wt,width:Ot,height:Ft}=qe,kt=Ot>0||Ft>0,re=Tm!=pt||Am!=wt||Rm!=Ot||Cm!=Ft;if(kt&&re&&wl(qe),Bn.setScale&&kt&&re){let Re=pt,Ee=Ot,ge=wt,Jt=Ft;if(P.ori==1&&(Re=wt,Ee=Ft,ge=pt,Jt=Ot),Nn&&Fs(T,Zi(Re,T),Zi(Re+Ee,T)),Dn)for(let Yt in w){let Ye=w[Yt];Yt!=T&&Ye.from==null&&Ye.min!=ze&&Fs(Yt,Zi(ge+Jt,Yt),Zi(ge,Yt))}gd()}else dt.lock&&(dt._lock=!dt._lock,cr(S,!0,_!=null));_!=null&&(Sn(Dd,Bd),ha(Dd,n,Xe,je,F,It,null))}function G_(_,S,I,L,H,Z,ct){if(dt._lock)return;Qt(_);let pt=Os;if(Os){let wt=!0,Ot=!0,Ft=10,kt,re;P.ori==0?(kt=Nn,re=Dn):(kt=Dn,re=Nn),kt&&re&&(wt=Xe<=Ft||Xe>=F-Ft,Ot=je<=Ft||je>=It-Ft),kt&&wt&&(Xe=Xe<Kr?0:F),re&&Ot&&(je=je<Zr?0:It),cr(null,!0,!0),Os=!1}Xe=-10,je=-10,st.fill(null),cr(null,!0,!0),pt&&(Os=pt)}function Lm(_,S,I,L,H,Z,ct){dt._lock||(Qt(_),oa(),gd(),_!=null&&ha(fg,n,Xe,je,F,It,null))}function Nm(){M.forEach(LM),O(n.width,n.height,!0)}_r(zl,lo,Nm);let Qr={};Qr.mousedown=Im,Qr.mousemove=Em,Qr.mouseup=Pm,Qr.dblclick=Lm,Qr.setSeries=(_,S,I,L)=>{let H=_n.match[2];I=H(n,S,I),I!=-1&&Ki(I,L,!0,!1)},gt&&(Se(hg,p,Im),Se(Nd,p,Em),Se(ug,p,_=>{Qt(_),ca(!1)}),Se(dg,p,G_),Se(fg,p,Lm),qd.add(n),n.syncRect=ca);let bl=n.hooks=i.hooks||{};function On(_,S,I){Kn?De.push([_,S,I]):_ in bl&&bl[_].forEach(L=>{L.call(null,n,S,I)})}(i.plugins||[]).forEach(_=>{for(let S in _.hooks)bl[S]=(bl[S]||[]).concat(_.hooks[S])});let Dm=(_,S,I)=>I,_n=bn({key:null,setSeries:!1,filters:{pub:Sg,sub:Sg},scales:[T,v[1]?v[1].scale:null],match:[Eg,Eg,Dm],values:[null,null]},dt.sync);_n.match.length==2&&_n.match.push(Dm),dt.sync=_n;let Om=_n.key,xd=w0(Om);function ha(_,S,I,L,H,Z,ct){_n.filters.pub(_,S,I,L,H,Z,ct)&&xd.pub(_,S,I,L,H,Z,ct)}xd.sub(n);function W_(_,S,I,L,H,Z,ct){_n.filters.sub(_,S,I,L,H,Z,ct)&&Qr[_](null,S,I,L,H,Z,ct)}n.pub=W_;function $_(){xd.unsub(n),qd.delete(n),Ln.clear(),Vd(zl,lo,Nm),c.remove(),Rt?.remove(),On("destroy")}n.destroy=$_;function vd(){On("init",i,t),ra(t||i.data,!1),V[T]?hd(T,V[T]):oa(),it=qe.show&&(qe.width>0||qe.height>0),et=mt=!0,O(i.width,i.height)}return v.forEach(Gr),M.forEach(fs),e?e instanceof HTMLElement?(e.appendChild(c),vd()):e(n,vd):vd(),n}un.assign=bn;un.fmtNum=tf;un.rangeNum=Hl;un.rangeLog=Wl;un.rangeAsinh=jd;un.orient=br;un.pxRatio=Ce;un.join=Mb;un.fmtDate=nf,un.tzDate=Db;un.sync=w0;{un.addGap=gM,un.clipGaps=ql;let i=un.paths={points:A0};i.linear=C0,i.stepped=yM,i.bars=_M,i.spline=bM}var N0=3,NM=1.8;function D0(i,t,e,n,s){let[r,o]=[i.data[0],i.data[t]],a=l=>i.valToPos(r[l],"x",!0);return O0(r,o,e,n,s).map(([l,c])=>[a(l),a(c)])}function O0(i,t,e,n,s=[]){let r=[],o=-1;for(let a=e;a<=n;a++)Number.isFinite(t[a])&&(o>=0&&(a>o+1||s[a]||i[a]-i[o]>N0)&&r.push([o,a]),o=a);return r}function F0(i,t,e){let{ctx:n,bbox:s,data:r,series:o}=i,a=r[0],l=r[t],c=O0(a,l,0,a.length-1,e).filter(([f,p])=>p===f+1);if(!c.length||!a.length)return;let{scale:h="y",stroke:u}=o[t],d=f=>[i.valToPos(a[f],"x",!0),i.valToPos(l[f],h,!0)];n.save(),n.beginPath(),n.rect(s.left,s.top,s.width,s.height),n.clip(),n.strokeStyle=n.fillStyle=String(typeof u=="function"?u(i,t):u),n.lineWidth=un.pxRatio,n.setLineDash([1.5*un.pxRatio,3*un.pxRatio]);for(let[f,p]of c){n.beginPath(),n.moveTo(...d(f)),a[p]-a[f]<=N0&&n.lineTo(...d(p)),n.stroke();for(let x of[f,p])n.beginPath(),n.arc(...d(x),NM*un.pxRatio,0,2*Math.PI),n.fill()}n.restore()}var hf="11px system-ui, sans-serif",DM=14,U0=i=>getComputedStyle(document.documentElement).getPropertyValue(i).trim(),xo=class{constructor(t,e,n,s=!1){this.host=t,this.series=n;let r=n.filter(({low:d,high:f})=>d&&f);this.apart=[];let o=(d,f,p,x)=>D0(d,f,p,x,this.apart);this.names=[...n.map(({name:d})=>d),...r.flatMap(({low:d,high:f})=>[d??"",f??""])],this.own=s&&n.length>1;let a=d=>this.own?`y${d}`:"y",l=(d,f)=>({scale:a(f),stroke:`${d}80`,width:1,class:"bound",points:{show:!1},gaps:o});this.extremes=[];let c=(this.own?n:[null]).map((d,f)=>[a(f),{range:()=>FM(...this.extremes[f]??[null,null])}]),h=()=>U0("--faint"),u={stroke:()=>U0("--line"),width:1};this.uplot=new un({width:100,height:100,pxAlign:!1,cursor:{drag:{x:!1,y:!1},points:{size:6},sync:{key:"ropewalk"}},legend:{live:!0},scales:{x:{time:!1,auto:!1,range:(d,f,p)=>[f,p]},...Object.fromEntries(c)},axes:[{stroke:h,grid:u,ticks:{...u,size:4},font:hf,size:24,values:(d,f)=>bd(f,"s",!0)},...(this.own?n.slice(0,2):[null]).map((d,f)=>({scale:a(f),side:f===0?3:1,stroke:d?d.colour:h,grid:f===0?u:{show:!1},ticks:{...u,size:4},font:hf,size:OM,space:15,values:(p,x)=>bd(x,e)}))],series:[{label:"time",value:(d,f)=>f===null?"":`${f.toFixed(2)} s`},...n.map(({label:d,colour:f},p)=>({label:d,scale:a(p),stroke:f,width:1.6,points:{show:!1},gaps:o,value:(x,g)=>g===null?"":ce(g,e)})),...r.flatMap(d=>{let f=n.indexOf(d);return[l(d.colour,f),l(d.colour,f)]})],hooks:{drawSeries:[(d,f)=>f<=n.length&&F0(d,f,this.apart)]},bands:r.map(({colour:d},f)=>({series:[n.length+2*f+2,n.length+2*f+1],fill:`${d}40`}))},[[],...this.names.map(()=>[])],t),this.resize()}resize(){let t=this.host.querySelector(".u-legend"),e=t instanceof HTMLElement?t.offsetHeight:24,n=this.host.clientWidth,s=Math.max(60,this.host.clientHeight-e-2);n>40&&(this.uplot.width!==n||this.uplot.height!==s)&&this.uplot.setSize({width:n,height:s})}show(t,e,n,s){this.apart=e,this.extremes=this.own?this.series.map((r,o)=>k0(this.columnsOf(o,t))):[k0(t)],this.uplot.batch(()=>{this.uplot.setData(t,!1),this.uplot.setScale("x",{min:n,max:s})})}columnsOf(t,e){let{name:n,low:s,high:r}=this.series[t],o=new Set([n,s,r]);return e.filter((a,l)=>l===0||o.has(this.names[l-1]))}destroy(){this.uplot.destroy()}};function OM(i,t){let{ctx:e}=i,n=e.font;e.font=hf;let s=Math.max(0,...(t??[]).map(r=>e.measureText(r).width));return e.font=n,Math.max(52,Math.ceil(s)+DM)}function k0([,...i]){let[t,e]=[1/0,-1/0];for(let n of i)for(let s of n)Number.isFinite(s)&&(s<t&&(t=s),s>e&&(e=s));return t<=e?[t,e]:[null,null]}function FM(i,t){if(i===null||t===null||!Number.isFinite(i)||!Number.isFinite(t))return[0,1];let e=Math.max(.08*(t-i),.01*Math.max(Math.abs(i),Math.abs(t)),1e-9);return[i-e,t+e]}var UM=.1,kM=4;function B0({hello:i,status:t}){return i?.mode!=="live"||!t?1/0:Math.max(UM*t.speed,kM*t.dt*t.steps_per_frame)}function ba(i,t,e){let n=t.parts[0],s=i.scalars.map((u,d)=>[u,n.scalars[d]]),[r,o,a]=i.up,{seen:l}=n,c=u=>eo(i,n,u,"tension_low","tension_high"),h=u=>eo(i,n,u,"low","high");for(let u of e){let[d,f,p]=n.positions.subarray(3*u,3*u+3),x=d*r+f*o+p*a,g=BM(i,u);s.push([`height ${u}`,x],[`low height ${u}`,Math.min(x,h(l.leastHeight[u]))],[`high height ${u}`,Math.max(x,h(l.greatestHeight[u]))],[`speed ${u}`,eo(i,n,l.greatestSpeed[u],null,"speed_high")],[`tension ${u}`,c(l.greatestTension[g])],[`low tension ${u}`,c(l.leastTension[g])])}return l.greatestForce.forEach((u,d)=>s.push([`force ${d}`,u])),i.variants.slice(1).forEach((u,d)=>{s.push([`difference ${d+1}`,Be(i,t.parts[d+1],"difference")])}),s}function Ma({variants:[i,...t]}){return[[/^force \d+$/,JSON.stringify(i.anchors.map(({name:e})=>e))],[/^difference \d+$/,JSON.stringify(t.map(({label:e})=>e))],[/(height|speed|tension) \d+$/,String(i.nodes)]]}function BM(i,t){for(let{first:e,nodes:n}of i.variants[0].ropes)if(t>=e&&t<e+n)return Math.max(e,Math.min(t,e+n-2));return t}var uf=[2,5,10,30,60,1/0],zM=.1,HM=66,df={energies:"Energies",tension:"Tension",forces:"Forces",motion:"Height or speed",phase:"Phase plane",difference:"Difference"},VM=[["kinetic","kinetic",Qe[0]],["gravity","gravity, from the start",Qe[2]],["elastic","elastic",Qe[1]],["lost","lost",Qe[3]]],GM="lost: to friction, air, ground, obstacles, and what pulleys and contacts store",ff="(max-width: 700px), (max-height: 500px)",WM={tension:i=>({low:`low tension ${i}`,high:`tension ${i}`}),height:i=>({low:`low height ${i}`,high:`high height ${i}`}),speed:()=>({})},Jl=class{constructor(t,e){this.viewport=t,this.host=e,this.history=new Dl,this.window=10,this.back=0,this.wanted=()=>{},this.quantity="height",this.panels=new Map,this.lastDraw=0,this.soon=!1,this.turn=0,this.plots=z("div",{className:"plots"}),this.chips=z("div",{className:"chips"}),this.choice=z("select",{id:"graph-choice","aria-label":"Graph shown",onchange:()=>this.choose(this.choice.value)}),this.scroll=z("input",{type:"range",id:"graph-scroll",min:"0",max:"0",step:"any","aria-label":"Scroll back in time",oninput:()=>{this.back=Number(this.scroll.max)-Number(this.scroll.value),this.drawAll()}}),this.windowChoice=z("select",{id:"graph-window","aria-label":"Seconds shown",onchange:()=>this.setWindow(Number(this.windowChoice.value.replace("all","Infinity")))},...uf.map(n=>z("option",{value:Number.isFinite(n)?String(n):"all",selected:n===this.window},Number.isFinite(n)?`${n} s`:"all"))),this.quantityChoice=z("select",{id:"graph-quantity","aria-label":"Height or speed",onchange:()=>this.setQuantity()},z("option",{value:"height"},"Height"),z("option",{value:"speed"},"Speed")),this.own=!1,this.ownScales=z("button",{type:"button",className:"chip",id:"own-scales","aria-pressed":"false",title:"Each line fills the height: its shape is seen, whatever its size",onclick:()=>this.setOwn(!this.own)},"Own scales"),e.append(z("div",{className:"graph-bar"},this.chips,this.choice,this.quantityChoice,this.ownScales,z("label",{},z("span",{className:"words"},"Last"),this.windowChoice),this.scroll),this.plots),this.shown=new Set(matchMedia(ff).matches?["energies"]:["energies","tension","motion"]),t.session.on("frame",n=>this.take(n)),t.session.on("layout",n=>{this.history.tell(Ma(n)),this.rebuild()}),t.session.on("status",()=>this.bounds()),new ResizeObserver(()=>this.resize()).observe(this.plots),matchMedia(ff).addEventListener("change",()=>this.rebuild()),this.plots.addEventListener("wheel",n=>this.wheel(n),{passive:!1})}get open(){return!this.host.hidden}toggle(t=!this.open){if(this.host.hidden=!t,t)return this.rebuild();this.clear(),this.wanted()}take(t){let{layout:e}=this.viewport.session;if(!e)return;if(t.flags&2&&this.viewport.session.hello?.mode==="replay"){this.drawSoon();return}let n=ba(e,t,this.viewport.marks.followed);if(this.history.add(t.time,n,B0(this.viewport.session)),!this.open)return;if(!(t.flags&1)){this.drawSoon();return}let s=performance.now();if(s-this.lastDraw<HM/Math.max(1,this.panels.size))return;this.lastDraw=s;let r=[...this.panels.values()];this.turn=(this.turn+1)%Math.max(1,r.length),r[this.turn]&&this.draw(r[this.turn]),this.turn===0&&this.bounds()}clear(){for(let{plot:t,box:e}of this.panels.values())t instanceof xo&&t.destroy(),e.remove();this.panels.clear()}rebuild(){if(!this.open)return;this.clear();let t=(this.viewport.session.layout?.variants.length??1)>1,e=(this.viewport.session.layout?.variants[0].anchors.length??0)>0,n=Object.keys(df).filter(s=>(s!=="difference"||t)&&(s!=="forces"||e));this.chips.replaceChildren(...n.map(s=>this.chip(s))),this.offer(n),this.quantityChoice.hidden=!this.shown.has("motion");for(let s of n){if(!this.shown.has(s))continue;let r=z("div",{className:"plot",data:{kind:s},title:s==="energies"?GM:""});this.plots.append(r),this.panels.set(s,{kind:s,box:r,plot:null})}for(let s of this.panels.values())s.plot=this.make(s);requestAnimationFrame(()=>this.resize()),this.bounds(),this.wanted()}get span(){return Number.isFinite(this.window)?this.window:Math.max(uf[0],this.history.last-this.history.first)||uf[0]}chip(t){return z("button",{type:"button",className:"chip","aria-pressed":String(this.shown.has(t)),data:{graph:t},onclick:()=>{this.shown.delete(t)||this.shown.add(t),this.rebuild()}},df[t])}offer(t){matchMedia(ff).matches&&(this.shown=new Set([...this.shown,t[0]].slice(0,1)));let e=t.flatMap(s=>s==="motion"?["height","speed"]:[s]);this.choice.replaceChildren(...e.map(s=>z("option",{value:s},df[s]??`${s[0].toUpperCase()}${s.slice(1)}`)));let[n]=this.shown;this.choice.value=n==="motion"?this.quantity:n}choose(t){let e=t==="height"||t==="speed";if(this.shown=new Set([e?"motion":t]),!e)return this.rebuild();this.quantityChoice.value=t,this.setQuantity()}make({kind:t,box:e}){if(t==="phase")return new Ol(e);let n={energies:"J",tension:"N",forces:"N",motion:this.quantity==="height"?"m":"m/s",difference:"m"}[t];return new xo(e,n,this.series(t),this.own)}series(t){if(t==="energies")return VM.map(([r,o,a])=>({name:r,label:o,colour:a}));let e=this.viewport.session.layout?.variants??[];if(t==="difference")return e.slice(1).map((r,o)=>({name:`difference ${o+1}`,label:`${r.label}, rms`,colour:Qe[(o+1)%Qe.length]}));if(t==="forces")return(e[0]?.anchors??[]).slice(0,Qe.length).map(({name:r},o)=>({name:`force ${o}`,label:r,colour:Qe[o]}));let n=t==="tension"?"tension":this.quantity,s=[...this.viewport.marks.followed].map((r,o)=>({name:`${n} ${r}`,label:this.nodeName(r),colour:Qe[(o+1)%Qe.length],...WM[n](r)}));return t==="tension"?[{name:"tension_max",label:"largest",colour:Qe[0]},...s]:this.quantity==="speed"?[{name:"speed_high",label:"fastest",colour:Qe[0]},...s]:s.length?s:[{name:"high",label:"highest",colour:Qe[0]},{name:"low",label:"lowest",colour:Qe[5]}]}nodeName(t){let e=this.viewport.session.layout?.variants[0].ropes??[],n=e.find(({first:s,nodes:r})=>t>=s&&t<s+r);return e.length>1&&n?`${n.name} ${t-n.zero}`:`node ${t-(n?.zero??0)}`}draw({kind:t,plot:e}){if(!Number.isFinite(this.history.last))return;let n=this.history.last-this.back,s=Math.min(Math.max(n-this.span,this.history.first),n-zM),r=n>0?Math.max(s,0):s;if(e instanceof xo){let o=this.history.apartBetween(r,n);e.show(this.history.between(r,n,e.names),o,r,n)}else if(e&&t==="phase"){let o=[...this.viewport.marks.followed][0],[a,l]=this.history.between(r,n,[`height ${o}`]);e.show(a,l,Qe[1])}}drawSoon(){this.soon||(this.soon=!0,requestAnimationFrame(()=>{this.soon=!1,this.bounds(),this.drawAll()}))}drawAll(){for(let t of this.panels.values())this.draw(t)}bounds(){let t=this.viewport.session.status?.playing??!0,e=Math.max(0,this.history.last-this.history.first-this.span)||0;t&&(this.back=0),this.scroll.disabled=t||e===0,this.scroll.title=t?"Pause to scroll back":"Scroll back in time",this.scroll.max=String(e),this.scroll.value=String(e-this.back),t||this.drawAll()}wheel(t){if(this.scroll.disabled)return;t.preventDefault();let e=(t.deltaX||t.deltaY)/400*this.span;this.back=Math.min(Number(this.scroll.max),Math.max(0,this.back-e)),this.bounds()}setWindow(t){this.window=t,this.back=0,this.wanted(),this.bounds(),this.drawAll()}setOwn(t){this.own=t,this.ownScales.setAttribute("aria-pressed",String(t)),this.rebuild()}setQuantity(){this.quantity=this.quantityChoice.value,this.rebuild()}resize(){for(let{plot:t}of this.panels.values())t?.resize();this.drawAll()}};var $M=.05,XM=250,qM=(i,t)=>i>0&&t>0?i/t:0,YM=(i,t)=>`energy${t&&` of ${t}`} off by up to ${Te(100*i)} %`,jl=class{constructor(t){this.session=t,this.host=z("div",{className:"numbers balance",id:"balance",hidden:!0}),this.written=-1/0,t.on("frame",e=>this.show(e))}show({parts:t}){let{layout:e}=this.session;if(!e||t.length!==e.variants.length||performance.now()-this.written<XM)return;this.written=performance.now();let s=t.map((a,l)=>{let c=Be(e,a,"energy_off");return{v:l,off:c,share:qM(c,Be(e,a,"energy_turned"))}}).reduce((a,l)=>l.share>a.share?l:a),{label:r}=e.variants[s.v],o=s.share>$M?YM(s.share,t.length>1?r:""):"";this.host.title=`${ce(s.off,"J")}, that part of the energy turned over, is in no law's work: the error of steps. Forces and places are as doubtful. Take a shorter step.`,this.host.hidden=!o,this.host.textContent!==o&&(this.host.textContent=o)}};var Ql=class{constructor(t,e){this.name=z("span",{className:"scene-name"},"…"),this.choose=z("button",{type:"button",className:"scene-choice",id:"open-scenes",title:"Scenes",onclick:e.scenes},this.name,bi("down")),this.tour=wn("tour","Guided tour",e.tour,{words:"Tour",id:"open-tour"}),this.compare=wn("compare","Compare copies",e.compare,{words:"Compare",id:"open-compare"}),this.keep=wn("keep","Save, export, link",()=>e.keep(this.keep),{words:"Keep",id:"open-keep"}),this.panel=wn("panel","Panel of constants",e.panel,{key:"P",id:"toggle-panel"}),t.append(z("strong",{className:"brand"},"Ropewalk"),this.choose,z("span",{className:"gap"}),this.tour,this.compare,this.keep,wn("help","Help",e.help,{key:"H",id:"open-help"}),wn("theme","Light or dark",e.theme,{key:"T",id:"toggle-theme"}),this.panel)}show(t){this.name.textContent=t,this.choose.setAttribute("aria-label",`Scene: ${t}. Choose another`),document.title=`${t} – Ropewalk`}};var tc=60,KM=400,ZM=400,JM=.3,jM=430;function pf(i,t,e,n){if(!n)return!1;for(let s=0;s<e;s++){let[r,o]=i.project(...be(t.subarray(4*s,4*s+3)));if(r>n.left&&r<n.right&&o>n.top&&o<n.bottom)return!0}return!1}function mf(i,{width:t,height:e}){let n=e>3*tc&&(e<ZM||t<=jM);if(!i)return{top:n?tc:0,bottom:0};let s=e-i.top;return i.bottom<s?{top:i.bottom,bottom:0}:{top:tc,bottom:s}}function z0(i,{width:t,height:e}){return i&&t-i.right>KM?{...mf(null,{width:t,height:e}),left:i.right}:null}function H0(i,{width:t,height:e}){if(e>3*tc)return{};let n=o=>(o.left+o.right)/2,s=Math.max(0,...i.filter(o=>n(o)<t/2).map(o=>o.right)),r=Math.min(t,...i.filter(o=>n(o)>=t/2).map(o=>o.left));return r-s>JM*t?{left:s,right:t-r}:{}}function Gs(i,t){if(!i.getClientRects().length)return null;let{x:e,y:n,width:s,height:r}=i.getBoundingClientRect(),o=t.getBoundingClientRect();return new DOMRect(e-o.x,n-o.y,s,r)}function V0(i){return i?i.bound===null?"The rope was moved farther in one step than the computation can follow. Try a shorter step.":i.stable?"The step is short enough for a rope at its length, so something pulled or threw a piece of it too far: a hand, a fast anchor, a heavy load. Be gentler, or take a shorter step.":i.rubs?"Each step was too long for so much friction: it is to slow a piece of the rope down, but in one step it threw the piece back faster than it came, in the next step faster still, and so on. A real rope would not do this; the computation did. A shorter step, less friction or more mass keep it together.":i.spring_factor===0?"Each step was too long for what damps the rope, or for what it touches: it is to slow a piece of the rope down or to push it back, but in one step it threw the piece back faster than it came, and so on. A real rope would not do this; the computation did. Softer springs do not help: a shorter step, less damping, softer contacts or more mass keep it together.":"Each step was too long for so stiff and light a rope: within one step a piece of it flew past where its neighbours pull it back to, then farther past on the other side, and so on. A real rope would not do this; the computation did. A shorter step, softer springs or more mass keep it together.":"The rope has flown apart. Why is being looked at."}function G0(i){return i?i.bound===null?"It was moved too far in one step.":i.stable?"Something pulled or threw a piece of it too far.":i.rubs?"Each step was too long for so much friction.":i.spring_factor===0?"Each step was too long for damping and contacts.":"Each step was too long for so stiff and light a rope.":"Why is being looked at."}function W0(i){if(!i||i.meter===null||i.meter_limit===null)return"";let{meter:t,meter_limit:e,meter_name:n}=i;return`The meter: ${n} = ${Te(t)}, at most ${Te(e)}.`}var QM=300,tS=3,eS=.38,nS={back:"Back to before",step:"Use the suggested step",implicit:"Use an implicit method",on:"Go on with these values"},ec=class{constructor(t,e,n){this.session=t,this.draw=n,this.timer=0,this.broken=null,this.card=z("section",{className:"card broken",hidden:!0,role:"alert",id:"broken"}),e.append(this.card),this.host=e,new ResizeObserver(()=>this.fold()).observe(e),t.on("broken",s=>this.show(s)),t.on("frame",({flags:s})=>this.tellReplay((s&2)!==0))}tellReplay(t){let{hello:e,layout:n}=this.session;e?.mode!=="replay"||this.card.hidden!==t||(this.card.hidden=!t,!(!t||!n?.broke)&&this.card.replaceChildren(z("h2",{},"The run broke"),z("p",{},n.broke.text||`It broke after t = ${Te(n.broke.time)} s.`),z("p",{className:"faint"},"Shown: steps past the last good frame. No number counts them.")))}show(t){let e=this.broken;this.broken=t,this.card.hidden=t===null;let n=t&&e&&iS(e,t);if(n||clearTimeout(this.timer),!t)return;n||this.begin();let[s,r,o]=["p.short","p.why","p.theory"].map(l=>this.part(l));Sa(s,G0(t.cause)),Sa(r,V0(t.cause)),Sa(o,`${t.text} ${W0(t.cause)}`);let a=t.remedies.map((l,c)=>this.way(l,c===0));sS(this.part(".row"),[...a,...this.look(t)]),this.fold()}begin(){this.card.replaceChildren(z("h2",{},"The simulation broke"),z("p",{className:"short"}),z("p",{className:"why"}),z("details",{},z("summary"),z("p",{className:"theory"})),z("div",{className:"row"}))}part(t){return this.card.querySelector(t)}way(t,e){let n={type:"remedy",remedy:t.id},s=this.part(`[data-remedy="${t.id}"]`)??z("button",{type:"button",data:{remedy:t.id},onclick:()=>this.session.tell(n)});return s.className=e?"main":"second",Sa(s,t.label||nS[t.id]),s}fold(){let[t,e]=["p.why","details"].map(s=>this.card.querySelector(s));if(!t||!e||this.card.hidden)return;this.card.classList.remove("tight"),e.before(t);let n=this.card.scrollHeight>eS*this.host.clientHeight;this.card.classList.toggle("tight",n),n&&e.children[0].after(t),Sa(e.children[0],n?"Why, in words and numbers":"The theory, in numbers")}place(t){return Gs(this.card,t)}look(t){let{past:e}=t;if(!e?.length)return[];let n=[this.part("#see-break"),this.part("#past")];if(n[0])return n;let s=z("span",{className:"faint",id:"past"}),r=l=>{let c=e[Math.min(l,e.length-1)],h=l===e.length+tS;this.draw(h?null:c.positions,t.variant),s.textContent=h?"":`${c.time.toFixed(5)} s: past the last good state`,h||(this.timer=window.setTimeout(()=>r(l+1),QM))};return[z("button",{type:"button",className:"second",id:"see-break",onclick:()=>{clearTimeout(this.timer),r(0)}},"See it break"),s]}};function iS(i,t){return i.variant===t.variant&&i.time===t.time&&i.step===t.step}function Sa(i,t){i.textContent!==t&&(i.textContent=t)}function sS(i,t){for(let n of[...i.children])t.includes(n)||n.remove();let e=i.firstElementChild;for(let n of t)n===e?e=e.nextElementSibling:i.insertBefore(n,e)}function vo(i){let t=[],e=0;for(let n of i.variants)t.push(e),e+=n.nodes;return t}var ti=i=>i.variants.reduce((t,e)=>t+e.nodes,0);function yo(i,t,e){let n=i.variants.length>1?t:i.variants[t].ropes[e].color;return gr(Qe[n%Qe.length])}function gf(i,t=[]){let e=vo(i),n=[];return i.variants.forEach((s,r)=>{s.ropes.forEach((o,a)=>{for(let l of rS(o,t[r]??[]))n.push({name:o.name,first:e[r]+l.first,count:l.nodes,radius:o.diameter/2,spacing:o.length/Math.max(1,o.segments),colour:yo(i,r,a),loose:oS(s,l)})})}),{nodes:ti(i),ropes:n}}function rS({first:i,nodes:t},e){let n=i+t-1,s=e.filter(r=>r>=i&&r<n).sort((r,o)=>r-o);return[...s,n].map((r,o)=>{let a=o===0?i:s[o-1]+1;return{first:a,nodes:r-a+1}})}var $0=(i,t)=>i.variants.map(({gaps:e})=>(e??[]).filter(n=>n.time<=t).map(({index:n})=>n));function oS({anchors:i,loads:t,joints:e},{first:n,nodes:s}){let r=new Set([...i,...t].map(({index:o})=>o));for(let o of e??[])for(let a of o.nodes)r.add(a);return[!r.has(n),!r.has(n+s-1)]}function X0(i){let t=vo(i),e=new Uint8Array(ti(i));return i.variants.forEach(({anchors:n,loads:s,joints:r},o)=>{for(let{index:a}of[...n,...s])e[t[o]+a]=1;for(let a of r??[])for(let l of a.nodes)e[t[o]+l]=1}),e}function q0(i,t,e,n){return i.variants.map((s,r)=>Dt(e,t?r*n:0))}function Y0(i,t){let{low:e,high:n}=i,r=i.scale==="log"&&e>0?e*(n/e)**t:e+t*(n-e);return i.whole?Math.round(r):Number(r.toPrecision(3))}function K0(i,t){let{low:e,high:n}=i,r=i.scale==="log"&&e>0?Math.log(Math.max(t,e)/e)/Math.log(n/e):(t-e)/(n-e);return Math.min(1,Math.max(0,Number.isFinite(r)?r:0))}function Ws(i){return $s(i)||i.trim()===""?NaN:Number(xf(i))}function $s(i,t=""){let e=i.trim();if(lS.test(e))return`${e}: a comma is a decimal point here; write ${e.replaceAll(",","")}`;let[,n,s=""]=aS.exec(xf(i))??[];return e===""||n&&s===""&&Number.isFinite(Number(n))?"":cS.test(xf(i))||n&&s===""?`${e}: must be a finite number`:n?s==="%"?`${e}: write ${Number((Number(n)/100).toPrecision(12))}`:`${e}: write the number alone${t&&`, in ${t}`}`:`${e}: is no number`}var xf=i=>i.trim().replace(",",".").replace("−","-"),aS=/^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*(.*)$/i,lS=/^[-+−]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?$/,cS=/^[+-]?(nan|inf|infinity|∞)$/i;function _o(i,t=11){let e=String(Number(i.toPrecision(6)));return e.length<=t?e:Number(i.toPrecision(t-5)).toExponential()}var hS=["bdf2","rk4"],uS=3,nc=class{constructor(t,e,n,s){this.viewport=t,this.colours=s,this.changes=[],this.rows=z("div",{className:"compare-rows"}),this.fault=z("p",{className:"fault",hidden:!0,role:"alert"}),this.add=z("button",{type:"button",className:"second",onclick:()=>this.addRow()},"One more copy"),this.apart=z("select",{id:"compare-way","aria-label":"How copies are shown",onchange:()=>this.viewport.setApart(this.apart.value==="apart")},z("option",{value:"over"},"overlaid"),z("option",{value:"apart"},"side by side")),this.stop=z("button",{type:"button",className:"second",id:"compare-end",onclick:()=>this.end()},"End the comparison"),this.window=so("Compare","compare",z("p",{},"Copies of this scene run beside it with one constant changed, moved by the same hand."),this.rows,this.fault,z("div",{className:"row"},this.add,z("span",{className:"gap"}),this.stop,z("button",{type:"button",className:"main",id:"compare-start",onclick:()=>this.start()},"Compare"))),e.append(this.window),this.lines=z("div",{}),this.card=z("div",{className:"card difference",hidden:!0,id:"difference"},z("div",{className:"row"},z("strong",{},"Copies"),this.apart,z("button",{type:"button",className:"second small",onclick:()=>this.end()},"End")),this.lines),n.append(this.card),t.card=()=>this.place(),this.lastShown=0,this.wasMany=!1,this.fresh=!1,t.session.on("layout",()=>this.layout()),t.session.on("frame",()=>this.show())}open(){let t=new Set(this.choices.map(({name:e})=>e));this.changes=this.changes.filter(({name:e})=>t.has(e)),this.changes.length||(this.changes=this.suggested()),this.fill(),this.stop.hidden=!this.wasMany,this.window.showModal()}suggested(){let{parameters:t,status:e,stability:n}=this.viewport.session,s=t.find(c=>c.name==="method"),r=n[0]?.steps??{},o=(s?.choices??[]).map(({value:c})=>c),a=c=>(r[c]??1/0)>(e?.dt??0),l=hS.find(c=>c!==s?.value&&o.includes(c));return l&&a(l)?[{name:"method",value:l}]:e?[{name:"time_step",value:e.dt/2}]:[]}get choices(){return this.viewport.session.parameters.filter(t=>t.kind!=="vector"&&t.enabled)}addRow(){let{status:t}=this.viewport.session;this.changes.push({name:"time_step",value:t?t.dt/2:.001}),this.fill()}fill(){this.add.disabled=this.changes.length>=uS,this.rows.replaceChildren(...this.changes.map((t,e)=>this.row(t,e)))}row(t,e){let n=this.choices.find(o=>o.name===t.name)??this.choices[0],s=z("select",{"aria-label":`What copy ${e+1} changes`,onchange:()=>{let o=this.choices.find(a=>a.name===s.value);this.changes[e]={name:s.value,value:o?.value},this.fill()}},...this.choices.map(o=>z("option",{value:o.name,selected:o===n},o.label))),r=z("button",{type:"button",className:"second small","aria-label":`Remove copy ${e+1}`,onclick:()=>{this.changes.splice(e,1),this.fill()}},"Remove");return z("div",{className:"row"},s,this.valueField(n,t),r)}valueField(t,e){if(t.kind==="choice"||t.kind==="flag"){let s=t.choices??[!0,!1].map(o=>({value:o,label:o?"yes":"no"})),r=z("select",{"aria-label":t.label,onchange:()=>e.value=s[r.selectedIndex].value},...s.map(({value:o,label:a})=>z("option",{selected:o===e.value},a)));return r.selectedIndex>=0&&(e.value=s[r.selectedIndex].value),r}let n=z("input",{type:"text",inputMode:"decimal","aria-label":t.label,value:typeof e.value=="number"?_o(e.value):"",oninput:()=>{e.value=Ws(n.value),e.fault=$s(n.value,wi(t.unit))}});return z("label",{},n,wi(t.unit))}label({name:t,value:e}){let n=this.viewport.session.parameters.find(s=>s.name===t);return n?.kind==="choice"||typeof e!="number"?String(e):`${n?.label??t} ${ce(e,n?.unit)}`}async start(){let t=this.changes.map(e=>({label:this.label(e),changes:{[e.name]:e.value}}));try{let e=this.changes.find(({fault:n})=>n);if(e)throw{text:e.fault};await this.viewport.session.ask({type:"compare",variants:t}),this.fault.hidden=!0,this.window.close()}catch(e){this.fault.textContent=e.text,this.fault.hidden=!1}}async end(){this.window.close(),await this.viewport.session.tell({type:"compare",variants:[]})}layout(){let t=this.viewport.session.layout,e=t.variants.length>1;this.card.hidden=!e,e!==this.wasMany&&this.colours(e),e&&!this.wasMany&&(this.fresh=!0),this.wasMany=e,this.lastShown=-1/0,this.lines.replaceChildren(...t.variants.map((n,s)=>{let r=z("i",{});return r.style.background=Ue(yo(t,s,0)),z("div",{className:"line"},r,z("span",{},n.label),z("output",{}))}))}place(){return Gs(this.card,this.viewport.renderer.canvas)}show(){let{layout:t,frame:e}=this.viewport.session,n=performance.now();!t||!e||this.card.hidden||e.flags&1&&n-this.lastShown<200&&!this.fresh||(this.lastShown=n,e.parts.forEach((r,o)=>{let a=this.lines.children[o]?.querySelector("output");if(!a||o===0)return;let l=ce(Be(t,r,"difference"),"m"),c=ce(Be(t,r,"difference_max"),"m");a.textContent=`differs by ${l} rms, ${c} at most`}),this.fresh&&this.viewport.uncover(),this.fresh=!1)}};var ic=class{constructor(t){this.rate=t,this.force=NaN,this.quick=0,this.phase=0}restart(){[this.force,this.quick,this.phase]=[NaN,0,0]}add(t,e,n){if(!Number.isFinite(t))return;let s=this.quick,r=Math.exp(-2*Math.PI*20*e);Number.isFinite(this.force)&&(this.quick=r*(s+t-this.force)),this.force=t;let o=e*this.rate,a=1-this.phase;for(;a<=o;)n.push(s+(this.quick-s)*(a/o)),a+=1;this.phase=1-(a-o)}},sc=class{constructor(){this.context=null,this.resampler=new ic(1),this.samples=[],this.loudest=0,this.next=0}get on(){return this.context!==null}turn(t){t&&!this.context?(this.context=new AudioContext,this.resampler=new ic(this.context.sampleRate),this.next=0):!t&&this.context&&(this.context.close(),this.context=null)}restart(){this.resampler.restart(),this.samples=[],this.loudest=0}hear(t,e){this.resampler.add(t,e,this.samples)}play(){let{context:t,samples:e}=this;if(!t||e.length===0)return;this.samples=[];for(let a of e)this.loudest=Math.max(this.loudest,Math.abs(a));let n=Math.max(this.next,t.currentTime+.06);if(n>t.currentTime+.25)return;let s=t.createBuffer(1,e.length,t.sampleRate),r=this.loudest>0?.25/this.loudest:0;s.copyToChannel(Float32Array.from(e,a=>r*a),0);let o=t.createBufferSource();o.buffer=s,o.connect(t.destination),o.start(n),this.next=n+e.length/t.sampleRate}};var rc=class{constructor(t){this.session=t,this.sound=new sc,this.heard=0,this.button=wn("sound","Sound of the first anchor's force",()=>this.turn(),{id:"sound"}),this.show(),t.on("sound",({seconds:e,forces:n})=>this.hear(e,n)),t.on("hello",()=>{this.show(),this.sound.on&&t.send({type:"listen",on:!0})}),t.on("status",({playing:e})=>e||this.sound.restart())}turn(){this.sound.turn(!this.sound.on),this.sound.restart(),this.session.send({type:"listen",on:this.sound.on}),this.show()}show(){this.button.hidden=!this.session.can("listen"),this.button.setAttribute("aria-pressed",String(this.sound.on))}hear(t,e){if(this.sound.on){this.heard+=e.length;for(let n of e)this.sound.hear(n,t);this.sound.play()}}};var dS=100,vf=[.01,.02,.05,.1,.2,.5,1,2,4],Z0=i=>i>=.995?`${Te(i)}×`:`1/${Te(1/i)}×`,oc=class{constructor(t,e,n){this.session=t,this.reset=wn("reset","Reset to time zero",()=>this.doReset(),{key:"R",id:"reset"}),this.undo=wn("undo","Undo",()=>this.doUndo(),{id:"undo"}),this.play=wn("play","Play",()=>this.toggle(),{key:"space",id:"play",kind:"main"}),this.step=wn("step","One step",()=>this.doStep(),{key:"full stop",id:"step"}),this.clock=z("output",{id:"clock",title:"Simulated time"},"0.00 s"),this.speed=z("input",{type:"range",id:"speed",min:"0",max:String(vf.length-1),step:"1","aria-label":"Speed",oninput:()=>this.setSpeed()}),this.speedText=z("output",{id:"speed-text"},"1×"),this.reached=z("output",{id:"realtime",className:"faint"},""),this.seek=z("input",{type:"range",id:"seek",min:"0",max:"1",step:"any","aria-label":"Time in the recording",oninput:()=>this.doSeek()}),this.graphs=wn("graph","Graphs",n,{words:"Graphs",key:"G",id:"toggle-graphs"}),this.hearing=new rc(t),this.seeking=0,this.resetting=!1,this.shown=-1/0,e.append(z("div",{className:"group"},this.reset,this.undo,this.play,this.step),this.clock,this.seek,z("label",{className:"speed",title:"Speed, as a part of real time"},"Speed",this.speed,this.speedText),this.reached,z("span",{className:"gap"}),this.hearing.button,this.graphs),t.on("hello",()=>this.refresh()),t.on("status",()=>this.refresh()),t.on("connection",()=>this.refresh()),t.on("frame",s=>this.showTime(s.time)),this.refresh()}refresh(){let{session:t}=this,{status:e}=t;this.play.hidden=!t.can("play"),this.step.hidden=!t.can("step"),this.reset.hidden=!t.can("reset"),this.undo.hidden=!t.can("undo");let n=this.speed.parentElement;if(n.hidden=!t.can("speed"),this.seek.hidden=!t.can("seek")||!e?.duration,!e)return;!e.playing&&t.frame&&this.showTime(t.frame.time);let s=e.undo?`Undo ${e.undo}`:"Nothing to undo";this.undo.disabled=t.gone||!e.undo,this.undo.title=`${s} (Ctrl+Z)`,this.undo.setAttribute("aria-label",s),this.reset.disabled=this.speed.disabled=t.gone,this.play.disabled=t.gone||e.broken,this.step.disabled=t.gone||e.broken||e.playing;let r=e.playing?"pause":"play";if(this.play.dataset.shows!==r){this.play.dataset.shows=r,this.play.replaceChildren(bi(r,r==="play"));let a=e.playing?"Pause":"Play";this.play.title=`${a} (space)`,this.play.setAttribute("aria-label",a)}document.activeElement!==this.speed&&(this.speed.value=String(pS(e.speed))),this.speedText.textContent=Z0(e.speed);let o=e.playing&&!t.gone;this.reached.textContent=o?fS(e.realtime):"paused",this.reached.classList.toggle("slow",e.slow),this.reached.title=e.text||"Simulated time per real time, over the last half second",e.duration&&(this.seek.max=String(e.duration))}showTime(t){let e=performance.now();if(e-this.shown>=dS||!this.session.status?.playing){this.shown=e;let n=`${t.toFixed(2)} s`;this.clock.textContent!==n&&(this.clock.textContent=n)}!this.seek.hidden&&document.activeElement!==this.seek&&(this.seek.value=String(t))}toggle(){let{status:t}=this.session;!t||t.broken||!this.session.can("play")||this.session.tell({type:t.playing?"pause":"play"})}async doStep(){let{status:t}=this.session;!t||t.broken||!this.session.can("step")||(t.playing?await this.session.tell({type:"pause"}):await this.session.tell({type:"step"}))}async doReset(){!this.session.can("reset")||this.resetting||(this.resetting=!0,await this.session.tell({type:"reset"}),this.resetting=!1)}doUndo(){!this.session.status?.undo||!this.session.can("undo")||(this.undoing(),this.session.tell({type:"undo"}))}undoing(){}setSpeed(){let t=vf[Number(this.speed.value)];this.speedText.textContent=Z0(t),this.session.tell({type:"speed",value:t})}doSeek(){cancelAnimationFrame(this.seeking),this.seeking=requestAnimationFrame(()=>{this.session.send({type:"seek",time:Number(this.seek.value)})})}},fS=i=>i===null?"":`reached ${Te(i)}×`;function pS(i){let t=vf.map(e=>Math.abs(Math.log(e/i)));return t.indexOf(Math.min(...t))}var mS=[["Drag an anchor (a ring)","it follows the hand, in the plane of a flat scene, else parallel to the screen; at most 30 m/s in the rope's time"],["Drag the rope","by a soft spring; its force is shown in newtons, and below the tools one may limit it"],["Drag an obstacle","it is moved in the plane of the screen, and takes along what lies on it; with Shift it is turned"],["Let go in motion","throws it: it has the hand's velocity"],["Hold Shift at the end of a drag","the spring stays; double-click on empty space lets go"],["Right-click, or a long press","pin, cut, load, tie, kick, follow; of an obstacle: turn it"],["Tie","press two points, or drag from one to the other: hands bring them together at 1 m/s and tie them"],["Drag empty space","turn the view; with Shift, the right button or near a rope: shift it"],["Wheel, or two fingers","zoom"]],gS=[["← → ↑ ↓","move the first anchor at 3 m/s"],["Home, End","move it away from you, towards you"],["A D W S Q E","the same for the second anchor"],["J L I K U O","the same for the third anchor"],["Tab, Enter","on the scene: the next place on the ropes, or obstacle, and its menu"],["Page Up, Page Down","turn the obstacle that Tab has chosen; arrow keys, Home and End move it"],["Space","play or pause; paused it stays so, over a reset or another scene"],[".","one step"],["R","reset to time zero"],["Ctrl Z","undo the last cut, pin, load, tie, kick, reset or move of an obstacle"],["F","show everything"],["G","graphs"],["P","panel of constants"],["T","light or dark"],["H or ?","this help"]],ac=class{constructor(t){let e=(n,s)=>z("dl",{},...n.flatMap(([r,o])=>[z("dt",{},z(s,{},r)),z("dd",{},o)]));this.version=z("p",{className:"faint"}),this.window=so("Help","help",z("div",{className:"columns"},z("section",{},z("h3",{},"Hand"),e(mS,"span")),z("section",{},z("h3",{},"Keys"),e(gS,"kbd"))),this.version),t.append(this.window)}open(){this.window.open?this.window.close():this.window.showModal()}};var xS={"nodes.csv":"Table of nodes (CSV)","energies.csv":"Table of energies (CSV)","tension.csv":"Table of tension (CSV)","scene.toml":"Scene (TOML)","page.html":"Page that replays it (HTML)"},lc=class{constructor(t,e,n){this.viewport=t,this.host=e,this.notices=n}open(t){let{session:e}=this.viewport,{base:n}=e.source,{hello:s}=e,r=[{label:"Save the run",id:"keep-save",hint:s?.folder??"",show:e.can("save")&&!e.gone,press:()=>this.save()},{label:"Copy the link to this set-up",id:"keep-link",show:e.can("scene")&&!e.gone,press:()=>this.copyLink()},{label:"Copy the command line",id:"keep-command",show:e.can("scene")&&J0(e.status?.address)!=="",press:()=>this.copyCommand()},{label:"Picture (PNG)",id:"keep-png",show:!0,press:()=>this.picture()},...(s?.exports??[]).map(l=>({label:xS[l]??l,id:`keep-${l.replace(".","-")}`,show:!e.gone,press:()=>this.file(`${n}export/${l}`,l)}))],o=t.getBoundingClientRect(),a=this.host.getBoundingClientRect();ro(this.host,o.right-a.left-240,o.bottom-a.top+4,r.filter(({show:l})=>l),"Keep")}async save(){await this.viewport.session.tell({type:"save"})}async file(t,e){this.notices.say(`Making ${e} …`);try{let n=await fetch(t);if(!n.ok)throw new Error((await n.text()).trim()||"it cannot be made here");let s=URL.createObjectURL(await n.blob());Pd(s,e),setTimeout(()=>URL.revokeObjectURL(s),1e4),this.notices.say(`${e} is in your downloads.`)}catch(n){let r=n instanceof TypeError?"the server is not there":n instanceof Error?n.message:n;this.notices.say(`${e}: ${r}`,"fault")}}picture(){this.viewport.draw(!0),this.viewport.renderer.canvas.toBlob(t=>{if(!t)return;let e=URL.createObjectURL(t);Pd(e,`${vS(this.viewport.session.layout?.scene.name??"rope")}.png`),setTimeout(()=>URL.revokeObjectURL(e),1e4)})}async copyLink(){let t=this.viewport.session.status,e=`${location.href.split("#")[0]}${t?.address?`#${t.address}`:""}`;await this.copy(e,"The link is copied. It opens this scene with these constants, as long as this view runs.")}async copyCommand(){let t=J0(this.viewport.session.status?.address);await this.copy(t,"The command is copied. In a terminal it opens this set-up again.")}async copy(t,e){try{await navigator.clipboard.writeText(t),this.notices.say(e)}catch{this.notices.say(t)}}};function J0(i){let t=new URLSearchParams(i??""),e=t.get("toml")||!["","start"].includes(t.get("scene")??"");return!i||!e?"":`ropewalk view --at "${i}"`}var vS=i=>i.toLowerCase().replace(/[^a-z0-9]+/g,"-").replace(/^-|-$/g,"")||"rope";function j0([i,t],[e,n],[s,r],o){let a=Math.hypot(e,n),[l,c]=a>1?[e/a,n/a]:[1,0],h=5+Math.min(s/2/Math.abs(l||1e-9),r/2/Math.abs(c||1e-9)),u=[i+l*h,t+c*h],d=s/2+15,f=r/2+15,[p,x]=[s/2+5,r/2+5],[g,m]=[l<0?-1:1,c<0?-1:1],v=[u,[i+g*p,t+m*x],[i-g*p,t+m*x],[i+g*p,t-m*x],[i,t-f],[i,t+f],[i+d,t],[i-d,t],[i-g*p,t-m*x],[i,t-f-1.5*r],[i,t+f+1.5*r]],M=(w,R)=>Math.max(2,Math.min(w,R-2));return v.map(([w,R])=>({x:M(w-s/2,o[0]-s),y:M(R-r/2,o[1]-r),width:s,height:r}))}function yf(i,t,e){return!t.some(n=>yS(i,n))&&!e.some(([n,s])=>n>i.x&&n<i.x+i.width&&s>i.y&&s<i.y+i.height)}function yS(i,t){return i.x<t.x+t.width&&t.x<i.x+i.width&&i.y<t.y+t.height&&t.y<i.y+i.height}var _S=7.4,wS=22,bS=18,MS=2.5,Q0=600,SS=10,ES=90,TS=".toolbar, .legend, .difference, .tour, .broken, .slow-note, .banner",AS=100,RS=1e3,cc=class{constructor(t,e){this.viewport=t,this.host=e,this.box=z("div",{className:"labels","aria-hidden":"true"}),this.known=new Map,this.cards=[],this.watched=new Set,this.looked=this.worded=-1/0,this.waits=!1,this.later=0,this.watch=new ResizeObserver(()=>{this.looked=-1/0,t.marks.dirty=!0}),this.watch.observe(e),e.append(this.box),t.afterDraw.push(()=>this.refresh()),t.session.on("status",()=>t.marks.dirty=!0)}refresh(){let{labels:t}=this.viewport.marks,e=t.flatMap(({from:a,at:l})=>[this.plate(a,SS),this.plate(l,MS)]),n=t.length?[...this.cardsNow(),...e]:[],s=t.length?this.beads():[],r=performance.now();this.waits=!1;let o=r-this.worded>=AS||!this.viewport.session.status?.playing;o&&(this.worded=r),this.forget(t);for(let a of t){let{element:l}=this.known.get(a.id)??this.add(a),h=(o||l.hidden?a.text:l.textContent)??"",u=this.place({...a,text:h},n,s);l.hidden===(u!==null)&&(l.hidden=!l.hidden),u&&(n.push(u),l.textContent!==h&&(l.textContent=h),l.style.transform=`translate(${Math.round(u.x)}px, ${Math.round(u.y)}px)`)}o&&this.viewport.marks.written(),this.waits&&!this.later&&(this.later=setTimeout(()=>this.lookAgain(),Q0))}forget(t){let e=new Set(t.map(({id:n})=>n));for(let[n,{element:s}]of this.known)e.has(n)||(s.remove(),this.known.delete(n))}add({id:t,kind:e}){let n=z("span",{className:e,hidden:!0}),s={element:n,taken:0,since:-1/0};return this.known.set(t,s),this.box.append(n),s}lookAgain(){this.later=0,this.viewport.marks.dirty=!0}place({id:t,from:e,at:n,text:s},r,o){let{camera:a}=this.viewport,[l,c,h]=a.project(...n);if(!(h>0))return null;let[u,d]=a.project(...e),f=[_S*s.length+bS,wS],p=[a.width,a.height],x=j0([l,c],[l-u,c-d],f,p),g=this.known.get(t),m=g.taken,v=performance.now(),M=v-g.since<Q0?[m,...x.keys()]:[...x.keys()],R=M.find(T=>yf(x[T],r,o))??M.find(T=>yf(x[T],r,[]));return R===void 0?null:(R!==m?g.since=v:R>0&&M.length>x.length&&(this.waits=!0),g.taken=R,x[R])}plate(t,e){let[n,s]=this.viewport.camera.project(...t);return{x:n-e,y:s-e,width:2*e,height:2*e}}beads(){let{camera:t,nodes:e,session:n}=this.viewport,s=n.layout?ti(n.layout):0,r=Math.max(1,Math.ceil(s/ES)),o=[];for(let a=0;a<s;a+=r){let[l,c,h]=e.shown.subarray(4*a,4*a+3);o.push(t.project(l,c,h))}return o}cardsNow(){let t=performance.now();if(t-this.looked<RS)return this.cards;this.looked=t;let{left:e,top:n}=this.host.getBoundingClientRect();return this.cards=[...this.host.querySelectorAll(TS)].map(s=>{this.watched.has(s)||this.watch.observe(s),this.watched.add(s);let{x:r,y:o,width:a,height:l}=s.getBoundingClientRect();return{x:r-e,y:o-n,width:a,height:l}}),this.cards}};var tx=3,CS=1e-4,ex=1e-9;function nx(i,t){let e=10**(Math.floor(Math.log10(i))+1-tx),n=t===Math.ceil?-ex:ex;return Te(Number((t(i/e*(1+n))*e).toPrecision(tx)))}function sx(i){if(!(i>CS))return`${i>0?"under 0.01":0} %`;let t=`${nx(100*i,Math.ceil)} %`;return i>1?`${t}: more than it bears`:`${t}, safety factor ${nx(1/i,Math.floor)}`}function rx({variants:i},t){return i.flatMap(({label:e,ropes:n},s)=>n.flatMap((r,o)=>{let{name:a,breaking_load:l,least_load:c=null}=r;if(!l)return[];let h=Math.max(0,t[s][o]);return[{name:i.length>1?`${e}, ${a}`:a,share:h/l,worst:h/(c||l),least:c}]}))}function ox(i,t=i.length){if(!i.length)return"";if(!i.every(({share:a})=>Number.isFinite(a)))return"Most now: not known";let e=i.reduce((a,l)=>l.share>a.share?l:a),n=i.reduce((a,l)=>{let c=l.worst===a.worst&&l===e;return l.worst>a.worst||c?l:a}),r=[`Most now: ${t>1?`${e.name}, `:""}${sx(e.share)}`];e.least!==null&&r.push(ix(e,"Its breaking load is a guess")),n!==e&&n.least!==null&&r.push(ix(n,`${n.name} may be nearer: its breaking load is a guess`));let o=t-i.length;return o&&r.push(`${o} of ${t} ropes: no breaking load known`),r.join(`
`)}var ix=({worst:i,least:t},e)=>`${e}; if it is only ${ce(t??0,"N")}: ${sx(i)}`;var wf=56,lx=200,IS=.03,PS=.2,hc=5,LS=1e-9;function bf({contact:i,ropeContacts:t},e){let n=NS(i,lx).map(s=>_f(be(e.subarray(4*s)),be(i.subarray(3*s))));for(let s=0;s<t.length;s+=hc){let[r,o,...a]=t.subarray(s,s+hc);r>=0&&(n.push(_f(ax(r,e),be(a))),n.push(_f(ax(o,e),Dt(a,-1))))}return n}var _f=(i,t)=>({from:i,force:t,size:Math.hypot(...t)});function ax(i,t){let e=Math.floor(i),n=be(t.subarray(4*e));if(i===e)return n;let s=be(t.subarray(4*e+4));return lt(Dt(n,1-(i-e)),s,i-e)}var Mf=i=>i.reduce((t,{size:e})=>Math.max(t,e),0);function Sf(i,t,e,n){return t>LS?i.filter(({size:s})=>s>=IS*t).map(({from:s,force:r,size:o})=>({from:s,to:lt(s,r,e/t),colour:n,pixels:2,head:o>PS*t})):[]}function cx({session:i,nodes:t,marks:e},n){if(!i.frame||!e.contacts)return[];let s=bf(i.frame.parts[0],t.to),r=Math.max(Mf(s),e.firmest);if(!(r<1/0))return[];let o=wf*n.pose.distance/n.focal;return Sf(s,r,o,[0,0,0]).map(({to:a})=>be(a))}function hx(i,t){let e=Be(i,t,"rope_contacts"),[n,s]=[0,0];for(let o=0;o<t.ropeContacts.length;o+=hc)t.ropeContacts[o]>=0&&(n+=1,s+=Math.hypot(...t.ropeContacts.subarray(o+2,o+hc)));let r=Be(i,t,"rope_contact_force");return e>n&&n>0?{drawn:n,all:e,share:s/r}:null}function ux(i,t){let e=Math.ceil(t/lx),n=i?[`Arrows at the ${i.drawn} strongest of ${i.all} contacts of ropes, ${Math.round(100*i.share)} % of their force.`]:[];return e>1&&n.push(`On obstacles at the strongest of every ${e} nodes.`),n.join(" ")}function NS(i,t){let e=o=>Math.hypot(i[3*o],i[3*o+1],i[3*o+2]),n=i.length/3,s=Math.max(1,Math.ceil(n/t)),r=[];for(let o=0;o<n;o+=s){let a=o;for(let l=o+1;l<Math.min(o+s,n);l++)e(l)>e(a)&&(a=l);r.push(a)}return r}var dx=8,DS=5,uc=4,OS=.25,FS=1e4,US=.001,kS=1.03,fx=1e-9,BS=1e-9,px="ropes on ropes",zS="(min-width: 701px) and (min-height: 740px)",HS="By which angle a rope turns towards an obstacle, its tensions before and after, and the ratio of these. It slips at exp(friction × angle) round a drum, if it has no weight, does not move and nothing else lies on it. In brackets: how much of that angle its ratio takes.";function VS({obstacles:i,variants:[{ropes:t}]},{wraps:e,ropeContacts:n}){let s=[];for(let r=0;r<e.length;r+=dx){let[o,a,l,c,h,u,d,f]=e.subarray(r,r+dx);if(!(o>=0))continue;let p=[t[o]?.name??"",i?.[a]?.name??""];s.push({rope:p[0],obstacle:p[1],angle:h,before:u,after:d,slip:Math.exp(f),pressed:GS(n,(t[o]?.zero??0)+l,c-l)})}return s}function GS(i,t,e){for(let n=0;n<i.length;n+=DS)for(let s of i.subarray(n,n+2))if(i[n]>=0&&s>=t-1&&s<=t+e+1)return!0;return!1}function WS({before:i,after:t}){let[e,n]=[Math.min(i,t),Math.max(i,t)];return e>fx?n/e:NaN}function $S(i,t){let{rope:e,obstacle:n,angle:s,before:r,after:o}=i,a=`${t?`${e} on `:""}${n}: ${Math.round(180/Math.PI*s)}°`,l=c=>c>fx?ce(c,"N"):"slack";return[`${a}, ${l(r)} → ${l(o)}`,XS(i)]}function XS(i){let t=WS(i),e=i.pressed?"held by ropes on it, too":"more than its turn holds";if(Number.isNaN(t))return i.pressed?e:"one side is slack";let n=`ratio ${Te(Number(t.toPrecision(3)))}`;if(i.slip<1+US)return`${n}, no friction along it`;if(i.slip>FS)return`${n}, slips at none`;let s=Math.log(t)/Math.log(i.slip),r=`slips at ${Te(i.slip)}`;return s>kS?`${n}, ${r}: ${e}`:i.pressed?`${n}, ${r} without the ropes on it`:`${n}, ${r} (${Te(Number((100*Math.min(s,1)).toPrecision(2)))} %)`}function qS({variants:[{surfaces:i}]},{frictionWork:t}){return[...t].map((e,n)=>({name:i?.[n]??"",taken:-e})).filter(({name:e,taken:n})=>e&&(e===px?n:Math.abs(n))>=BS).sort((e,n)=>Math.abs(n.taken)-Math.abs(e.taken))}function YS(i,t){if(![...t.frictionWork].some(Number.isFinite))return"";let e=qS(i,t);if(!e.length)return"Friction has taken nothing yet";let n=e.slice(0,uc).map(({name:s,taken:r})=>{let o=s===px?"between ropes":`on ${s}`;return`${r<0?"gave ":""}${ce(Math.abs(r),"J")} ${o}`});return e.length>uc&&n.push(`and on ${e.length-uc} more`),`Friction ${e[0].taken<0?"":"took "}${n.join(", ")}`}var dc=class{constructor(){this.wraps=z("div",{id:"wrap-list"}),this.taken=z("p",{id:"friction-taken"}),this.summary=z("summary",{}),this.host=z("details",{className:"wraps",id:"wraps",hidden:!0,open:matchMedia(zS).matches},this.summary,z("div",{className:"wraps-body"},this.wraps,this.taken)),this.host.title=HS,this.text=""}show(t,e){let n=e?.parts[0],s=t&&n&&(n.wraps.length||n.frictionWork.length);if(this.host.hidden=!s,!s)return;let[r,o,a]=KS(t,n),l=JSON.stringify([r,o,a]);l!==this.text&&(this.text=l,this.summary.textContent=r,this.wraps.replaceChildren(...o.map(c=>z("p",{},...c.map(h=>z("span",{},h))))),this.taken.textContent=a,this.taken.hidden=!a)}};function KS(i,t){let e=VS(i,t),n=i.variants[0].ropes.length>1,s=e.slice(0,uc).map(l=>$S(l,n)),r=Be(i,t,"wraps");r>s.length&&s.push([`and ${r-s.length} more wraps`]);let o=Be(i,t,"wrap_age");return o>OS&&s.length&&s.push([`as it was ${ce(Number(o.toPrecision(2)),"s")} ago`]),[t.wraps.length?"Wraps and friction":"Friction",s,YS(i,t)]}var ZS=100,JS=1e-6,jS=2e-9;function QS(i,t){return i==="strain"||i==="utilisation"?["%",100]:i==="speed"?["m/s",1]:t>=1e7?["MN",1e-6]:t>=1e4?["kN",.001]:["N",1]}var t1=({forces:i,large:t})=>t?`The ${t} larger of ${i} forces. Point at others.`:`${i} forces, too small now for arrows. Point at an anchor.`,fc=class{constructor(t,e){this.viewport=t,this.written=-1/0,this.select=z("select",{id:"colouring","aria-label":"Colour of the ropes",onchange:()=>this.choose()},z("option",{value:"tension"},"Tension"),z("option",{value:"strain"},"Tension / EA"),this.near=z("option",{value:"utilisation",hidden:!0},"Tension / breaking load"),z("option",{value:"speed"},"Speed"),z("option",{value:"plain"},"Plain colours")),this.bar=z("div",{className:"map"}),this.dark=null,this.low=z("span",{}),this.middle=z("span",{}),this.high=z("span",{}),this.numbers=z("div",{className:"numbers",id:"legend-numbers"},this.low,this.middle,this.high),this.ropes=z("div",{className:"rope-names"}),this.arrows=this.check("Forces","show-forces",!0,n=>t.marks.reactions=n),this.dots=this.check("Nodes","show-nodes",!1,n=>t.dots=n),this.contacts=this.check("Contact","show-contacts",!0,n=>{t.marks.contacts=n}),this.contacts.hidden=!0,this.contacts.title="Forces of obstacles on ropes, and of ropes on each other: one on either rope. On a scale of their own",this.firmest=z("div",{className:"numbers",id:"contact-scale",hidden:!0}),this.fewer=z("div",{className:"numbers",id:"contacts-left-out",hidden:!0}),this.wraps=new dc,this.posts=this.check("Stands","show-posts",!0,n=>t.marks.standing=n),this.posts.title="What anchors stand on: drawn only, ropes pass through it",this.posts.className="posts",this.margin=z("div",{className:"numbers",id:"margin",hidden:!0}),this.given=z("div",{className:"numbers",id:"given",hidden:!0}),this.crowd=z("div",{className:"numbers",id:"crowd",hidden:!0}),this.grid=z("span",{}),this.thick=z("span",{}),e.append(this.card=z("div",{className:"card legend"},this.select,this.bar,this.numbers,this.margin,this.ropes,z("div",{className:"row"},this.arrows,this.dots,this.posts),z("div",{className:"row"},this.contacts,this.firmest),this.fewer,this.wraps.host,z("div",{className:"numbers drawn-as"},this.grid,this.thick),this.given,this.crowd)),t.session.on("layout",()=>this.names()),t.session.on("status",()=>this.refresh()),t.afterDraw.push(()=>{(!t.session.status?.playing||performance.now()-this.written>=ZS)&&this.refresh()})}check(t,e,n,s){let r=z("input",{type:"checkbox",id:e,checked:n,onchange:()=>{s(r.checked),this.viewport.dirty=!0}});return z("label",{},r,t)}place(){return Gs(this.card,this.viewport.renderer.canvas)}choose(){this.viewport.setColouring(this.select.value),this.names()}names(){this.written=-1/0;let{layout:t}=this.viewport.session,e=this.viewport.colouring==="plain";if(this.bar.hidden=this.numbers.hidden=e,this.ropes.replaceChildren(),t){this.tellGiven(t),this.contacts.hidden=!zm(t.variants[0].offsets);let r=t.variants.some(({ropes:o})=>o.some(a=>a.breaking_load));if(this.near.hidden=this.near.disabled=!r,!r&&this.viewport.colouring==="utilisation")return this.select.value="tension",this.choose()}if(this.margin.hidden=this.viewport.colouring!=="utilisation",!t||!e)return;let s=t.variants.length>1?t.variants.map((r,o)=>({name:r.label,colour:yo(t,o,0)})):t.variants[0].ropes.map((r,o)=>({name:r.name,colour:yo(t,0,o)}));for(let{name:r,colour:o}of s.slice(0,6)){let a=z("i",{});a.style.background=Ue(o),this.ropes.append(z("span",{},a,r))}s.length>6&&this.ropes.append(z("span",{className:"faint"},`and ${s.length-6} more`))}tellGiven({variants:[{ropes:t,forces:e}]}){let s=t.filter(({submerged_weight:o})=>typeof o=="number").slice(0,2).map(({name:o,submerged_weight:a})=>`${t.length>1?`${o} `:""}weighs ${ce(a,"N/m")} in water`);e.length&&s.push("arrows at nodes: constant forces");let r=s.join("; ");this.given.hidden=!r,Ui(this.given,r&&r[0].toUpperCase()+r.slice(1))}paint(){let{dark:t}=this.viewport.theme;if(t===this.dark)return;this.dark=t;let e=io(t),n=Array.from({length:17},(s,r)=>Ue(e[Math.round(r/16*(e.length-1))]));this.bar.style.backgroundImage=`linear-gradient(to right, ${n.join(", ")})`}refresh(){this.paint(),this.written=performance.now(),this.tellMargin();let{range:t,colouring:e,beyond:n}=this.viewport,{low:s,high:r}=t,[o,a]=[n[0]?"≤ ":"",n[1]?"≥ ":""],[l,c]=QS(e,Math.max(Math.abs(s),Math.abs(r))),h=d=>e1(d,c,r-s),u=r-s>jS;if(this.low.hidden=this.middle.hidden=!u,!u)return Ui(this.high,`${a}${h(s)} ${l}`),this.showGrid();Ui(this.low,`${o}${h(s)}`),Ui(this.middle,h((s+r)/2)),Ui(this.high,`${a}${h(r)} ${l}`),this.showGrid()}tellMargin(){let{session:t,tensions:e}=this.viewport,{layout:n}=t;if(this.margin.hidden||!n||e.length!==n.variants.length)return;let s=n.variants.reduce((r,o)=>r+o.ropes.length,0);Ui(this.margin,ox(rx(n,e),s))}tellCrowd(){let{reactions:t,crowd:e}=this.viewport.marks;this.crowd.hidden=!t||!e||e.large===e.forces,!this.crowd.hidden&&e&&Ui(this.crowd,t1(e))}tellContacts(){let{session:t,marks:e}=this.viewport,{layout:n,frame:s}=t;this.wraps.show(n,s);let r=!this.contacts.hidden&&e.contacts&&e.firmest>1e-9;if(this.firmest.hidden=!r,this.fewer.hidden=!0,!r||!n||!s)return;Ui(this.firmest,`longest ${ce(Number(e.firmest.toPrecision(2)),"N")}`);let[o]=s.parts,a=ux(hx(n,o),o.contact.length/3);this.fewer.hidden=!a,Ui(this.fewer,a)}showGrid(){this.tellContacts(),this.tellCrowd(),Ui(this.grid,`Grid ${ce(this.viewport.spacing,"m")}`);let t=this.viewport.thickness();Ui(this.thick,t>1.05?`Drawn ${Te(Number(t.toPrecision(2)))}× thick`:"True thickness")}};function Ui(i,t){i.textContent!==t&&(i.textContent=t)}var e1=(i,t,e)=>Te(Math.abs(i)<JS*e?0:Number((i*t).toPrecision(2)));var Sr=1.25,pc=class{constructor(t,e){this.session=t,this.host=e,t.on("stability",n=>this.show(n)),t.on("layout",()=>this.show(t.stability))}show(t){let e=t.length>1;this.host.hidden=t.length===0,this.host.classList.toggle("many",e),this.host.replaceChildren(...t.map((n,s)=>this.row(n,s,e)))}row(t,e,n){let{ratio:s,zone:r}=t,o=t.bound===null,a=this.session.layout?.variants[e]?.label,l=z("div",{className:"fill"});l.style.width=`${100*Math.min(1,(s??Sr)/Sr)}%`;let c=z("div",{className:"tick"});c.style.left=`${100/Sr}%`;let h=z("div",{className:"amber-zone"});h.style.left=`${90/Sr}%`,h.style.width=`${10/Sr}%`;let u=z("div",{className:"red-zone"});u.style.left=`${100/Sr}%`;let d=z("div",{className:"meter-bar",role:"meter","aria-label":"Step as a part of the largest stable step","aria-valuemin":"0","aria-valuemax":"1.25","aria-valuenow":String(s??(o?0:Sr)),"aria-valuetext":t.verdict},...o?[]:[l,h,u,c]),f=[];return t.bound===null?f.push([t.verdict,"why"]):t.bound>0&&f.push([`largest step ${ce(t.bound,"s")}`,"step"]),t.largest_spring_constant!==null?f.push([`largest spring constant ${ce(t.largest_spring_constant,"N/m")}`,"k"]):t.largest_axial_stiffness!==null&&f.push([`largest EA ${ce(t.largest_axial_stiffness,"N")}`,"k"]),z("div",{className:`meter-row ${r}`,title:t.verdict,data:{zone:r}},z("span",{className:"meter-name"},n&&a?a:"Stability"),d,z("strong",{className:"meter-ratio"},o?"no bound":s===null?"no stable step":n1(s)),...f.map(([p,x])=>z("span",{className:`meter-fact ${x}`},p)))}};function n1(i){return i>=10?`${Te(i)} times the bound`:`${Te(100*i)} % of the bound`}var i1=7e3,s1=40,r1=80,o1=3,mc=class{constructor(t,e){this.list=z("div",{className:"notices","aria-live":"polite"}),this.banner=z("div",{className:"banner",hidden:!0,role:"alert",id:"banner"}),this.slow=z("div",{className:"slow-note",hidden:!0,id:"slow"}),e.append(this.banner,this.slow,this.list),t.on("error",n=>this.say(n.text,"fault")),t.on("note",({text:n})=>this.say(n)),t.on("saved",({folder:n})=>this.say(`Saved in ${n}`)),t.on("connection",({state:n,text:s})=>this.connection(n,s)),t.on("status",({slow:n,text:s,broken:r,waits:o=""})=>{let a=o||n&&!r&&s||"";this.slow.hidden=!a,this.slow.classList.toggle("waits",o!==""),a&&this.slow.textContent!==a&&this.slow.replaceChildren(o&&z("span",{className:"spinner"}),a)})}connection(t,e){if(this.banner.hidden=t==="open",this.banner.classList.toggle("calm",t==="waiting"),document.documentElement.dataset.connection=t,t!=="open")if(t==="damaged")this.banner.replaceChildren(e);else{let n=t==="waiting"?"":" Trying again …";this.banner.replaceChildren(z("span",{className:"spinner"}),`${e}${n}`)}}say(t,e="note"){for(let r of this.list.children)r.firstChild?.textContent===t&&r.remove();let n=z("button",{type:"button",className:"plain","aria-label":"Close",onclick:()=>s.remove()},bi("close")),s=z("div",{className:`notice ${e}`},z("span",{},t),n);for(this.list.append(s);this.list.children.length>o1;)this.list.firstChild?.remove();return setTimeout(()=>s.remove(),i1+s1*Math.max(0,t.length-r1)),()=>s.remove()}};var mx=2;function a1({rope:i,place:t,length:e,tension:n,time:s}){let r=Math.min(t,e-t),o=t<=e/2?"start":"end",a=`${ce(r,"m")} from its ${o}`;return`${i} parted ${a}, at ${ce(n,"N")}, t = ${ce(s,"s")}`}var gc=class{constructor(t,e){this.session=t,this.say=e,this.host=z("div",{className:"numbers parted",id:"parted",hidden:!0}),this.host.title="A rope parts where its tension passes its breaking load",this.said=new Set,t.on("frame",({time:n})=>this.show(n)),t.on("layout",()=>this.show(t.frame?.time??-1/0))}show(t){let{layout:e}=this.session,n=(e?.variants.length??0)>1,s=(e?.variants??[]).flatMap(({parted:a,label:l})=>(a??[]).filter(c=>c.time<=t).map(c=>(n?`${l}: `:"")+a1(c)));for(let a of s)this.said.has(a)||this.say(a);this.said=new Set(s);let r=s.length-mx,o=[...s.slice(0,mx),...r>0?[`and ${r} more`]:[]].join(`
`);this.host.hidden=!o,this.host.textContent!==o&&(this.host.textContent=o)}};var xc=class{constructor(t,e){this.session=t,this.list=z("div",{className:"scene-themes"}),this.window=so("Scenes","scenes",this.list),e.append(this.window),t.on("presets",()=>this.fill()),t.on("layout",()=>this.mark())}open(){this.mark(),this.window.showModal()}fill(){let{presets:t}=this.session,e=[...new Set(t.map(({theme:n})=>n))];this.list.replaceChildren(...e.flatMap(n=>[z("h3",{},n),z("div",{className:"scene-list"},...t.filter(s=>s.theme===n).map(s=>this.card(s)))])),this.mark()}card(t){let{base:e}=this.session.source,n=z("div",{className:"picture"});return t.picture&&e&&(n.style.maskImage=`url("${new URL(e+t.picture,location.href.split(/[?#]/)[0]).href}")`),z("button",{type:"button",className:"scene-card",data:{preset:t.name},onclick:()=>this.choose(t.name)},n,z("strong",{},t.title),z("span",{},t.sentence))}mark(){let t=this.session.layout?.scene.preset;for(let e of this.list.querySelectorAll(".scene-card"))e instanceof HTMLElement&&e.classList.toggle("now",e.dataset.preset===t)}choose(t){this.window.close(),this.session.tell({type:"scene",preset:t})}};var gx=[["hand","hand","Hand: drag anchors and ropes",""],["pin","pin","Pin: hold a node where it is, or let it go again","pin"],["cut","cut","Cut a segment","cut"],["load","load","Hang a load on a node","load"],["tie","tie","Tie two points together: press one, then the other","tie"],["kick","kick","Kick: draw the velocity from a node","kick"],["follow","follow","Follow a node: its trail and its graphs",""]],vc=class{constructor(t,e,n,s){this.viewport=t,this.host=e,this.follow=n,this.say=s,this.pointer=null,this.unsay=()=>{},this.mass=1,this.buttons=new Map,this.bar=z("div",{className:"toolbar",role:"toolbar","aria-label":"Tools"});for(let[r,o,a]of gx){let l=wn(o,a,()=>this.choose(r),{id:`tool-${r}`});this.buttons.set(r,l),this.bar.append(l)}this.massField=z("input",{type:"text",inputMode:"decimal",value:"1",id:"load-mass","aria-label":"Mass to hang [kg]",onchange:()=>{let r=this.massField.value,o=Ws(r);this.refuse(r,"kg",o<0?"a mass must not be negative":""),o>=0&&(this.mass=o),this.massField.value=String(this.mass),this.massField.blur()}}),this.massBox=z("label",{className:"mass",hidden:!0},this.massField,"kg"),this.pullField=z("input",{type:"text",inputMode:"decimal",value:"",placeholder:"auto",id:"pull-limit",title:"Pull with at most this force; empty: 20 times the rope's weight","aria-label":"Largest force of a pull [N]; empty: 20 times the rope's weight",onchange:()=>this.limitPull()}),this.pullBox=z("label",{className:"mass pull",hidden:!0},this.pullField,"N"),this.bar.append(this.massBox,this.pullBox,Nl(this.bar,"All tools")),e.append(this.bar),t.session.on("hello",()=>this.refresh()),this.refresh()}refresh(){for(let[t,,,e]of gx){let n=this.buttons.get(t);n&&(n.hidden=e!==""&&!this.viewport.session.can(e))}this.choose(this.pointer?.tool??"hand")}choose(t){this.pointer&&(this.pointer.tool=t),this.tieNone();for(let[e,n]of this.buttons)n.setAttribute("aria-pressed",String(e===t));this.massBox.hidden=t!=="load",this.pullBox.hidden=t!=="hand"||!this.viewport.session.can("grab"),this.host.dataset.tool=t}limitPull(){let t=this.pullField.value,e=Ws(t);this.refuse(t,"N",e<=0?"must be positive; leave it empty for 20 weights":"");let n=e>0?e:null;this.pointer&&(this.pointer.limit=n),this.pullField.value=n===null?"":String(n),this.pullField.blur()}refuse(t,e,n){let s=n?`${t.trim()}: ${n}`:$s(t,e);s&&this.say(s,"fault")}use(t,e){let{session:n}=this.viewport,{node:s}=ts(n.layout,e);t==="pin"?e.kind==="anchor"?n.tell({type:"unpin",anchor:e.anchor}):n.tell({type:"pin",node:s}):t==="cut"?this.cut(e):t==="load"?n.tell({type:"load",node:s,mass:this.mass}):t==="follow"?this.follow(s):t==="tie"&&this.tie(e)}tie(t){let{session:e,marks:n}=this.viewport,s=n.tying;if(n.dirty=!0,!s){n.tying=t;let a=this.nodeName(t);this.unsay=this.say(`${a}: choose the point to tie it to; Esc lets it be`);return}this.tieNone();let[r,o]=[s,t].map(a=>ts(e.layout,a).node);e.tell({type:"tie",node:r,other:o})}tieNone(){let{marks:t}=this.viewport;t.tying&&(t.dirty=!0),t.tying=null,this.unsay()}cut(t){let{session:e}=this.viewport,{joint:n}=t,{segment:s}=ts(e.layout,t);n!==void 0&&e.can("untie")?e.tell({type:"untie",joint:n}):e.tell({type:"cut",segment:s})}bodyMenu({obstacle:t},e,n){let{viewport:s}=this,r=l=>()=>Cl(s,t,null,s.solids.angleOf(t)+l*Math.PI,!0),o=no(s,t),a=[{label:"Turn it by 15° (Page Up)",press:r(1/12),disabled:!o},{label:"Turn it back by 15° (Page Down)",press:r(-1/12),disabled:!o}];ro(this.host,e,n,a,`Obstacle ${t}`)}menu(t,e,n){let{session:s,marks:r}=this.viewport;if(t?.kind==="obstacle"){this.bodyMenu(t,e,n);return}if(!t){ro(this.host,e,n,[{label:"Show everything",press:()=>this.viewport.fit()},{label:"Let go of everything",press:()=>s.send({type:"let_go"}),disabled:!s.can("let_go")}]);return}let{node:o,segment:a}=ts(s.layout,t),c=(s.layout?.variants[0].loads.filter(p=>p.index===o)??[]).reduce((p,x)=>p+x.mass,0),h=this.viewport.camera.up,d=[t.kind==="anchor"?{label:"Let this node go",command:"unpin",press:()=>s.tell({type:"unpin",anchor:t.anchor})}:{label:"Pin it here",command:"pin",press:()=>s.tell({type:"pin",node:o})},...t.joint!==void 0?[{label:`Cut the joint ${t.joint}`,command:"untie",press:()=>this.cut(t)}]:[],{label:"Cut here",command:"cut",press:()=>s.tell({type:"cut",segment:a})},...[1,10].map(p=>({label:`Hang ${p} kg here`,command:"load",press:()=>s.tell({type:"load",node:o,mass:p})})),...c>0?[{label:`Take the load off (${Te(c)} kg)`,command:"load",press:()=>s.tell({type:"load",node:o,mass:0})}]:[],{label:r.tying?`Tie ${this.nodeName(r.tying)} to it`:"Tie it to another point",command:"tie",press:()=>this.tie(t)},{label:"Kick it up (5 m/s)",command:"kick",press:()=>s.tell({type:"kick",node:o,velocity:Dt(h,5)})}].filter(p=>s.can(p.command)),f=r.followed.has(o);ro(this.host,e,n,[...d,{label:f?"Stop following":"Follow: trail and graphs",press:()=>this.follow(o)}],this.nodeName(t))}nodeName(t){if(t.kind==="anchor")return`Anchor ${t.anchor}`;let e=this.viewport.session.layout?.variants[t.variant].ropes??[],n=e.find(({first:s,nodes:r})=>t.node>=s&&t.node<s+r);return n?t.joint!==void 0?`Joint ${t.joint}`:`Node ${t.node-n.zero}${e.length>1?` of ${n.name}`:""}`:`Node ${t.node}`}};var l1=["r4","hanging-rope"],c1=2,xx="bdf2",Ea=[{title:"Hang it",text:"A rope is a chain of masses and springs. Let it hang and swing: its colour is the tension in newtons.",act:"Hang the rope",press:i=>i.hang(),done:({session:i,hung:t})=>t&&(i.frame?.time??0)>1},{title:"Move it",text:"Take an anchor, one of the squares, and move it. The arrow keys do it too, at 3 m/s. Then pull at the rope itself.",act:"",press:()=>{},done:({moved:i})=>i},{title:"Stiffen it until it breaks",text:"Make the springs stiffer and watch the meter: beyond the red line every step overshoots, nodes jump to and fro, and the rope breaks.",act:"Twice as stiff",press:i=>i.stiffen(),done:({session:i})=>i.broken!==null},{title:"Make the step smaller",text:"Nothing is wrong with the rope: the time step is too long for springs so stiff. A shorter step mends it, and costs more computing.",act:"Use a shorter step",press:i=>i.shorten(),done:({session:i})=>i.broken===null&&i.stability[0]?.stable===!0},{title:"Take an implicit method",text:"An implicit method solves for the next state and bears any stiffness with long steps. The meter has no red any more.",act:"Use an implicit method",press:i=>i.implicit(),done:({session:i})=>i.stability[0]?.bound===null}],yc=class{constructor(t,e){this.session=t,this.at=-1,this.hung=this.moved=!1,this.card=z("section",{className:"card tour",hidden:!0,"aria-label":"Guided tour",id:"tour"}),e.append(this.card),t.on("status",()=>this.check()),t.on("stability",()=>this.check()),t.on("broken",()=>this.check())}start(){if(this.at>=0){this.end();return}this.hung=this.moved=!1,this.go(0)}end(){this.at=-1,this.card.hidden=!0}handMoved(){this.moved||(this.moved=!0,this.check())}go(t){if(this.at=t,t>=Ea.length){this.end();return}let{title:e,text:n,act:s,press:r}=Ea[t],o=t===Ea.length-1;t===1&&(this.moved=!1);let a=t!==4||this.implicitMethod()!==null,l=z("button",{type:"button",className:"plain close","aria-label":"End the tour",onclick:()=>this.end()},bi("close"));this.card.replaceChildren(z("header",{},z("small",{},`Step ${t+1} of ${Ea.length}`),l),z("h2",{},e),z("p",{},n),a?"":z("p",{className:"faint"},"This version has no implicit method yet; a Runge-Kutta method bears a longer step."),z("div",{className:"row"},s!==""?z("button",{type:"button",className:"main",id:"tour-act",disabled:!a,onclick:()=>r(this)},s):"",z("span",{className:"gap"}),t>0?z("button",{type:"button",className:"second",onclick:()=>this.go(t-1)},"Back"):"",z("button",{type:"button",className:"second",id:"tour-next",onclick:()=>this.go(t+1)},o?"Finish":"Next"))),this.card.hidden=!1,this.check()}check(){if(this.at<0)return;let t=Ea[this.at].done(this);this.card.classList.toggle("done",t);let e=this.card.querySelector("#tour-next");e&&(e.className=t?"main":"second")}async hang(){let{session:t}=this,e=l1.find(n=>t.presets.some(s=>s.name===n))??t.presets[0]?.name;e&&t.can("scene")&&await t.tell({type:"scene",preset:e}),this.hung=!0,await t.tell({type:"play"})}async stiffen(){let{session:t}=this,e=t.parameters.find(n=>n.name==="spring_constant")??t.parameters.find(n=>n.name==="EA");!e||typeof e.value!="number"||(await t.tell({type:"set",name:e.name,value:e.value*c1}),t.status?.playing||await t.tell({type:"play"}))}async shorten(){let{session:t}=this;t.broken?await t.tell({type:"remedy",remedy:"step"}):await t.tell({type:"set",name:"time_step",value:"auto"}),await t.tell({type:"play"})}implicitMethod(){let e=this.session.parameters.find(s=>s.name==="method")?.choices??[];if(e.some(({value:s})=>s===xx))return xx;let n=e.find(({value:s,label:r})=>/implicit|sdirk|bdf|midpoint/i.test(`${s} ${r}`)&&!/semi-implicit/i.test(`${s}`));return n?n.value:null}async implicit(){let t=this.implicitMethod();t!==null&&(this.session.broken?await this.session.tell({type:"remedy",remedy:"implicit"}):await this.session.tell({type:"set",name:"method",value:t}),await this.session.tell({type:"play"}))}};var ns=class i{constructor(t,e,n,s,r="div"){this.parent=t,this.object=e,this.property=n,this._disabled=!1,this._hidden=!1,this.initialValue=this.getValue(),this.domElement=document.createElement(r),this.domElement.classList.add("lil-controller"),this.domElement.classList.add(s),this.$name=document.createElement("div"),this.$name.classList.add("lil-name"),i.nextNameID=i.nextNameID||0,this.$name.id=`lil-gui-name-${++i.nextNameID}`,this.$widget=document.createElement("div"),this.$widget.classList.add("lil-widget"),this.$disable=this.$widget,this.domElement.appendChild(this.$name),this.domElement.appendChild(this.$widget),this.domElement.addEventListener("keydown",o=>o.stopPropagation()),this.domElement.addEventListener("keyup",o=>o.stopPropagation()),this.parent.children.push(this),this.parent.controllers.push(this),this.parent.$children.appendChild(this.domElement),this._listenCallback=this._listenCallback.bind(this),this.name(n)}name(t){return this._name=t,this.$name.textContent=t,this}onChange(t){return this._onChange=t,this}_callOnChange(){this.parent._callOnChange(this),this._onChange!==void 0&&this._onChange.call(this,this.getValue()),this._changed=!0}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(){this._changed&&(this.parent._callOnFinishChange(this),this._onFinishChange!==void 0&&this._onFinishChange.call(this,this.getValue())),this._changed=!1}reset(){return this.setValue(this.initialValue),this._callOnFinishChange(),this}enable(t=!0){return this.disable(!t)}disable(t=!0){return t===this._disabled?this:(this._disabled=t,this.domElement.classList.toggle("lil-disabled",t),this.$disable.toggleAttribute("disabled",t),this)}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}options(t){let e=this.parent.add(this.object,this.property,t);return e.name(this._name),this.destroy(),e}min(t){return this}max(t){return this}step(t){return this}decimals(t){return this}listen(t=!0){return this._listening=t,this._listenCallbackID!==void 0&&(cancelAnimationFrame(this._listenCallbackID),this._listenCallbackID=void 0),this._listening&&this._listenCallback(),this}_listenCallback(){this._listenCallbackID=requestAnimationFrame(this._listenCallback);let t=this.save();t!==this._listenPrevValue&&this.updateDisplay(),this._listenPrevValue=t}getValue(){return this.object[this.property]}setValue(t){return this.getValue()!==t&&(this.object[this.property]=t,this._callOnChange(),this.updateDisplay()),this}updateDisplay(){return this}load(t){return this.setValue(t),this._callOnFinishChange(),this}save(){return this.getValue()}destroy(){this.listen(!1),this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.controllers.splice(this.parent.controllers.indexOf(this),1),this.parent.$children.removeChild(this.domElement)}},Ef=class extends ns{constructor(t,e,n){super(t,e,n,"lil-boolean","label"),this.$input=document.createElement("input"),this.$input.setAttribute("type","checkbox"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$widget.appendChild(this.$input),this.$input.addEventListener("change",()=>{this.setValue(this.$input.checked),this._callOnFinishChange()}),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.checked=this.getValue(),this}};function Tf(i){let t,e;return(t=i.match(/(#|0x)?([a-f0-9]{6})/i))?e=t[2]:(t=i.match(/rgb\(\s*(\d*)\s*,\s*(\d*)\s*,\s*(\d*)\s*\)/))?e=parseInt(t[1]).toString(16).padStart(2,0)+parseInt(t[2]).toString(16).padStart(2,0)+parseInt(t[3]).toString(16).padStart(2,0):(t=i.match(/^#?([a-f0-9])([a-f0-9])([a-f0-9])$/i))&&(e=t[1]+t[1]+t[2]+t[2]+t[3]+t[3]),e?"#"+e:!1}var h1={isPrimitive:!0,match:i=>typeof i=="string",fromHexString:Tf,toHexString:Tf},Aa={isPrimitive:!0,match:i=>typeof i=="number",fromHexString:i=>parseInt(i.substring(1),16),toHexString:i=>"#"+i.toString(16).padStart(6,0)},u1={isPrimitive:!1,match:i=>Array.isArray(i)||ArrayBuffer.isView(i),fromHexString(i,t,e=1){let n=Aa.fromHexString(i);t[0]=(n>>16&255)/255*e,t[1]=(n>>8&255)/255*e,t[2]=(n&255)/255*e},toHexString([i,t,e],n=1){n=255/n;let s=i*n<<16^t*n<<8^e*n<<0;return Aa.toHexString(s)}},d1={isPrimitive:!1,match:i=>Object(i)===i,fromHexString(i,t,e=1){let n=Aa.fromHexString(i);t.r=(n>>16&255)/255*e,t.g=(n>>8&255)/255*e,t.b=(n&255)/255*e},toHexString({r:i,g:t,b:e},n=1){n=255/n;let s=i*n<<16^t*n<<8^e*n<<0;return Aa.toHexString(s)}},f1=[h1,Aa,u1,d1];function p1(i){return f1.find(t=>t.match(i))}var Af=class extends ns{constructor(t,e,n,s){super(t,e,n,"lil-color"),this.$input=document.createElement("input"),this.$input.setAttribute("type","color"),this.$input.setAttribute("tabindex",-1),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$text=document.createElement("input"),this.$text.setAttribute("type","text"),this.$text.setAttribute("spellcheck","false"),this.$text.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$display.appendChild(this.$input),this.$widget.appendChild(this.$display),this.$widget.appendChild(this.$text),this._format=p1(this.initialValue),this._rgbScale=s,this._initialValueHexString=this.save(),this._textFocused=!1,this.$input.addEventListener("input",()=>{this._setValueFromHexString(this.$input.value)}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$text.addEventListener("input",()=>{let r=Tf(this.$text.value);r&&this._setValueFromHexString(r)}),this.$text.addEventListener("focus",()=>{this._textFocused=!0,this.$text.select()}),this.$text.addEventListener("blur",()=>{this._textFocused=!1,this.updateDisplay(),this._callOnFinishChange()}),this.$disable=this.$text,this.updateDisplay()}reset(){return this._setValueFromHexString(this._initialValueHexString),this}_setValueFromHexString(t){if(this._format.isPrimitive){let e=this._format.fromHexString(t);this.setValue(e)}else this._format.fromHexString(t,this.getValue(),this._rgbScale),this._callOnChange(),this.updateDisplay()}save(){return this._format.toHexString(this.getValue(),this._rgbScale)}load(t){return this._setValueFromHexString(t),this._callOnFinishChange(),this}updateDisplay(){return this.$input.value=this._format.toHexString(this.getValue(),this._rgbScale),this._textFocused||(this.$text.value=this.$input.value.substring(1)),this.$display.style.backgroundColor=this.$input.value,this}},Ta=class extends ns{constructor(t,e,n){super(t,e,n,"lil-function"),this.$button=document.createElement("button"),this.$button.appendChild(this.$name),this.$widget.appendChild(this.$button),this.$button.addEventListener("click",s=>{s.preventDefault(),this.getValue().call(this.object),this._callOnChange()}),this.$button.addEventListener("touchstart",()=>{},{passive:!0}),this.$disable=this.$button}},Rf=class extends ns{constructor(t,e,n,s,r,o){super(t,e,n,"lil-number"),this._initInput(),this.min(s),this.max(r);let a=o!==void 0;this.step(a?o:this._getImplicitStep(),a),this.updateDisplay()}decimals(t){return this._decimals=t,this.updateDisplay(),this}min(t){return this._min=t,this._onUpdateMinMax(),this}max(t){return this._max=t,this._onUpdateMinMax(),this}step(t,e=!0){return this._step=t,this._stepExplicit=e,this}updateDisplay(){let t=this.getValue();if(this._hasSlider){let e=(t-this._min)/(this._max-this._min);e=Math.max(0,Math.min(e,1)),this.$fill.style.width=e*100+"%"}return this._inputFocused||(this.$input.value=this._decimals===void 0?t:t.toFixed(this._decimals)),this}_initInput(){this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("aria-labelledby",this.$name.id),window.matchMedia("(pointer: coarse)").matches&&(this.$input.setAttribute("type","number"),this.$input.setAttribute("step","any")),this.$widget.appendChild(this.$input),this.$disable=this.$input;let e=()=>{let v=parseFloat(this.$input.value);isNaN(v)||(this._stepExplicit&&(v=this._snap(v)),this.setValue(this._clamp(v)))},n=v=>{let M=parseFloat(this.$input.value);isNaN(M)||(this._snapClampSetValue(M+v),this.$input.value=this.getValue())},s=v=>{v.key==="Enter"&&this.$input.blur(),v.code==="ArrowUp"&&(v.preventDefault(),n(this._step*this._arrowKeyMultiplier(v))),v.code==="ArrowDown"&&(v.preventDefault(),n(this._step*this._arrowKeyMultiplier(v)*-1))},r=v=>{this._inputFocused&&(v.preventDefault(),n(this._step*this._normalizeMouseWheel(v)))},o=!1,a,l,c,h,u,d=5,f=v=>{a=v.clientX,l=c=v.clientY,o=!0,h=this.getValue(),u=0,window.addEventListener("mousemove",p),window.addEventListener("mouseup",x)},p=v=>{if(o){let M=v.clientX-a,w=v.clientY-l;Math.abs(w)>d?(v.preventDefault(),this.$input.blur(),o=!1,this._setDraggingStyle(!0,"vertical")):Math.abs(M)>d&&x()}if(!o){let M=v.clientY-c;u-=M*this._step*this._arrowKeyMultiplier(v),h+u>this._max?u=this._max-h:h+u<this._min&&(u=this._min-h),this._snapClampSetValue(h+u)}c=v.clientY},x=()=>{this._setDraggingStyle(!1,"vertical"),this._callOnFinishChange(),window.removeEventListener("mousemove",p),window.removeEventListener("mouseup",x)},g=()=>{this._inputFocused=!0},m=()=>{this._inputFocused=!1,this.updateDisplay(),this._callOnFinishChange()};this.$input.addEventListener("input",e),this.$input.addEventListener("keydown",s),this.$input.addEventListener("wheel",r,{passive:!1}),this.$input.addEventListener("mousedown",f),this.$input.addEventListener("focus",g),this.$input.addEventListener("blur",m)}_initSlider(){this._hasSlider=!0,this.$slider=document.createElement("div"),this.$slider.classList.add("lil-slider"),this.$fill=document.createElement("div"),this.$fill.classList.add("lil-fill"),this.$slider.appendChild(this.$fill),this.$widget.insertBefore(this.$slider,this.$input),this.domElement.classList.add("lil-has-slider");let t=(m,v,M,w,R)=>(m-v)/(M-v)*(R-w)+w,e=m=>{let v=this.$slider.getBoundingClientRect(),M=t(m,v.left,v.right,this._min,this._max);this._snapClampSetValue(M)},n=m=>{this._setDraggingStyle(!0),e(m.clientX),window.addEventListener("mousemove",s),window.addEventListener("mouseup",r)},s=m=>{e(m.clientX)},r=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("mousemove",s),window.removeEventListener("mouseup",r)},o=!1,a,l,c=m=>{m.preventDefault(),this._setDraggingStyle(!0),e(m.touches[0].clientX),o=!1},h=m=>{m.touches.length>1||(this._hasScrollBar?(a=m.touches[0].clientX,l=m.touches[0].clientY,o=!0):c(m),window.addEventListener("touchmove",u,{passive:!1}),window.addEventListener("touchend",d))},u=m=>{if(o){let v=m.touches[0].clientX-a,M=m.touches[0].clientY-l;Math.abs(v)>Math.abs(M)?c(m):(window.removeEventListener("touchmove",u),window.removeEventListener("touchend",d))}else m.preventDefault(),e(m.touches[0].clientX)},d=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("touchmove",u),window.removeEventListener("touchend",d)},f=this._callOnFinishChange.bind(this),p=400,x,g=m=>{if(Math.abs(m.deltaX)<Math.abs(m.deltaY)&&this._hasScrollBar)return;m.preventDefault();let M=this._normalizeMouseWheel(m)*this._step;this._snapClampSetValue(this.getValue()+M),this.$input.value=this.getValue(),clearTimeout(x),x=setTimeout(f,p)};this.$slider.addEventListener("mousedown",n),this.$slider.addEventListener("touchstart",h,{passive:!1}),this.$slider.addEventListener("wheel",g,{passive:!1})}_setDraggingStyle(t,e="horizontal"){this.$slider&&this.$slider.classList.toggle("lil-active",t),document.body.classList.toggle("lil-dragging",t),document.body.classList.toggle(`lil-${e}`,t)}_getImplicitStep(){return this._hasMin&&this._hasMax?(this._max-this._min)/1e3:.1}_onUpdateMinMax(){!this._hasSlider&&this._hasMin&&this._hasMax&&(this._stepExplicit||this.step(this._getImplicitStep(),!1),this._initSlider(),this.updateDisplay())}_normalizeMouseWheel(t){let{deltaX:e,deltaY:n}=t;return Math.floor(t.deltaY)!==t.deltaY&&t.wheelDelta&&(e=0,n=-t.wheelDelta/120,n*=this._stepExplicit?1:10),e+-n}_arrowKeyMultiplier(t){let e=this._stepExplicit?1:10;return t.shiftKey?e*=10:t.altKey&&(e/=10),e}_snap(t){let e=0;return this._hasMin?e=this._min:this._hasMax&&(e=this._max),t-=e,t=Math.round(t/this._step)*this._step,t+=e,t=parseFloat(t.toPrecision(15)),t}_clamp(t){return t<this._min&&(t=this._min),t>this._max&&(t=this._max),t}_snapClampSetValue(t){this.setValue(this._clamp(this._snap(t)))}get _hasScrollBar(){let t=this.parent.root.$children;return t.scrollHeight>t.clientHeight}get _hasMin(){return this._min!==void 0}get _hasMax(){return this._max!==void 0}},Cf=class extends ns{constructor(t,e,n,s){super(t,e,n,"lil-option"),this.$select=document.createElement("select"),this.$select.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$select.addEventListener("change",()=>{this.setValue(this._values[this.$select.selectedIndex]),this._callOnFinishChange()}),this.$select.addEventListener("focus",()=>{this.$display.classList.add("lil-focus")}),this.$select.addEventListener("blur",()=>{this.$display.classList.remove("lil-focus")}),this.$widget.appendChild(this.$select),this.$widget.appendChild(this.$display),this.$disable=this.$select,this.options(s)}options(t){return this._values=Array.isArray(t)?t:Object.values(t),this._names=Array.isArray(t)?t:Object.keys(t),this.$select.replaceChildren(),this._names.forEach(e=>{let n=document.createElement("option");n.textContent=e,this.$select.appendChild(n)}),this.updateDisplay(),this}updateDisplay(){let t=this.getValue(),e=this._values.indexOf(t);return this.$select.selectedIndex=e,this.$display.textContent=e===-1?t:this._names[e],this}},If=class extends ns{constructor(t,e,n){super(t,e,n,"lil-string"),this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("spellcheck","false"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$input.addEventListener("input",()=>{this.setValue(this.$input.value)}),this.$input.addEventListener("keydown",s=>{s.code==="Enter"&&this.$input.blur()}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$widget.appendChild(this.$input),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.value=this.getValue(),this}},m1=`.lil-gui {
  font-family: var(--font-family);
  font-size: var(--font-size);
  line-height: 1;
  font-weight: normal;
  font-style: normal;
  text-align: left;
  color: var(--text-color);
  user-select: none;
  -webkit-user-select: none;
  touch-action: manipulation;
  --background-color: #1f1f1f;
  --text-color: #ebebeb;
  --title-background-color: #111111;
  --title-text-color: #ebebeb;
  --widget-color: #424242;
  --hover-color: #4f4f4f;
  --focus-color: #595959;
  --number-color: #2cc9ff;
  --string-color: #a2db3c;
  --font-size: 11px;
  --input-font-size: 11px;
  --font-family: -apple-system, BlinkMacSystemFont, "Segoe UI", Roboto, Arial, sans-serif;
  --font-family-mono: Menlo, Monaco, Consolas, "Droid Sans Mono", monospace;
  --padding: 4px;
  --spacing: 4px;
  --widget-height: 20px;
  --title-height: calc(var(--widget-height) + var(--spacing) * 1.25);
  --name-width: 45%;
  --slider-knob-width: 2px;
  --slider-input-width: 27%;
  --color-input-width: 27%;
  --slider-input-min-width: 45px;
  --color-input-min-width: 45px;
  --folder-indent: 7px;
  --widget-padding: 0 0 0 3px;
  --widget-border-radius: 2px;
  --checkbox-size: calc(0.75 * var(--widget-height));
  --scrollbar-width: 5px;
}
.lil-gui, .lil-gui * {
  box-sizing: border-box;
  margin: 0;
  padding: 0;
}
.lil-gui.lil-root {
  width: var(--width, 245px);
  display: flex;
  flex-direction: column;
  background: var(--background-color);
}
.lil-gui.lil-root > .lil-title {
  background: var(--title-background-color);
  color: var(--title-text-color);
}
.lil-gui.lil-root > .lil-children {
  overflow-x: hidden;
  overflow-y: auto;
}
.lil-gui.lil-root > .lil-children::-webkit-scrollbar {
  width: var(--scrollbar-width);
  height: var(--scrollbar-width);
  background: var(--background-color);
}
.lil-gui.lil-root > .lil-children::-webkit-scrollbar-thumb {
  border-radius: var(--scrollbar-width);
  background: var(--focus-color);
}
@media (pointer: coarse) {
  .lil-gui.lil-allow-touch-styles, .lil-gui.lil-allow-touch-styles .lil-gui {
    --widget-height: 28px;
    --padding: 6px;
    --spacing: 6px;
    --font-size: 13px;
    --input-font-size: 16px;
    --folder-indent: 10px;
    --scrollbar-width: 7px;
    --slider-input-min-width: 50px;
    --color-input-min-width: 65px;
  }
}
.lil-gui.lil-force-touch-styles, .lil-gui.lil-force-touch-styles .lil-gui {
  --widget-height: 28px;
  --padding: 6px;
  --spacing: 6px;
  --font-size: 13px;
  --input-font-size: 16px;
  --folder-indent: 10px;
  --scrollbar-width: 7px;
  --slider-input-min-width: 50px;
  --color-input-min-width: 65px;
}
.lil-gui.lil-auto-place, .lil-gui.autoPlace {
  max-height: 100%;
  position: fixed;
  top: 0;
  right: 15px;
  z-index: 1001;
}

.lil-controller {
  display: flex;
  align-items: center;
  padding: 0 var(--padding);
  margin: var(--spacing) 0;
}
.lil-controller.lil-disabled {
  opacity: 0.5;
}
.lil-controller.lil-disabled, .lil-controller.lil-disabled * {
  pointer-events: none !important;
}
.lil-controller > .lil-name {
  min-width: var(--name-width);
  flex-shrink: 0;
  white-space: pre;
  padding-right: var(--spacing);
  line-height: var(--widget-height);
}
.lil-controller .lil-widget {
  position: relative;
  display: flex;
  align-items: center;
  width: 100%;
  min-height: var(--widget-height);
}
.lil-controller.lil-string input {
  color: var(--string-color);
}
.lil-controller.lil-boolean {
  cursor: pointer;
}
.lil-controller.lil-color .lil-display {
  width: 100%;
  height: var(--widget-height);
  border-radius: var(--widget-border-radius);
  position: relative;
}
@media (hover: hover) {
  .lil-controller.lil-color .lil-display:hover:before {
    content: " ";
    display: block;
    position: absolute;
    border-radius: var(--widget-border-radius);
    border: 1px solid #fff9;
    top: 0;
    right: 0;
    bottom: 0;
    left: 0;
  }
}
.lil-controller.lil-color input[type=color] {
  opacity: 0;
  width: 100%;
  height: 100%;
  cursor: pointer;
}
.lil-controller.lil-color input[type=text] {
  margin-left: var(--spacing);
  font-family: var(--font-family-mono);
  min-width: var(--color-input-min-width);
  width: var(--color-input-width);
  flex-shrink: 0;
}
.lil-controller.lil-option select {
  opacity: 0;
  position: absolute;
  width: 100%;
  max-width: 100%;
}
.lil-controller.lil-option .lil-display {
  position: relative;
  pointer-events: none;
  border-radius: var(--widget-border-radius);
  height: var(--widget-height);
  line-height: var(--widget-height);
  max-width: 100%;
  overflow: hidden;
  word-break: break-all;
  padding-left: 0.55em;
  padding-right: 1.75em;
  background: var(--widget-color);
}
@media (hover: hover) {
  .lil-controller.lil-option .lil-display.lil-focus {
    background: var(--focus-color);
  }
}
.lil-controller.lil-option .lil-display.lil-active {
  background: var(--focus-color);
}
.lil-controller.lil-option .lil-display:after {
  font-family: "lil-gui";
  content: "↕";
  position: absolute;
  top: 0;
  right: 0;
  bottom: 0;
  padding-right: 0.375em;
}
.lil-controller.lil-option .lil-widget,
.lil-controller.lil-option select {
  cursor: pointer;
}
@media (hover: hover) {
  .lil-controller.lil-option .lil-widget:hover .lil-display {
    background: var(--hover-color);
  }
}
.lil-controller.lil-number input {
  color: var(--number-color);
}
.lil-controller.lil-number.lil-has-slider input {
  margin-left: var(--spacing);
  width: var(--slider-input-width);
  min-width: var(--slider-input-min-width);
  flex-shrink: 0;
}
.lil-controller.lil-number .lil-slider {
  width: 100%;
  height: var(--widget-height);
  background: var(--widget-color);
  border-radius: var(--widget-border-radius);
  padding-right: var(--slider-knob-width);
  overflow: hidden;
  cursor: ew-resize;
  touch-action: pan-y;
}
@media (hover: hover) {
  .lil-controller.lil-number .lil-slider:hover {
    background: var(--hover-color);
  }
}
.lil-controller.lil-number .lil-slider.lil-active {
  background: var(--focus-color);
}
.lil-controller.lil-number .lil-slider.lil-active .lil-fill {
  opacity: 0.95;
}
.lil-controller.lil-number .lil-fill {
  height: 100%;
  border-right: var(--slider-knob-width) solid var(--number-color);
  box-sizing: content-box;
}

.lil-dragging .lil-gui {
  --hover-color: var(--widget-color);
}
.lil-dragging * {
  cursor: ew-resize !important;
}
.lil-dragging.lil-vertical * {
  cursor: ns-resize !important;
}

.lil-gui .lil-title {
  height: var(--title-height);
  font-weight: 600;
  padding: 0 var(--padding);
  width: 100%;
  text-align: left;
  background: none;
  text-decoration-skip: objects;
}
.lil-gui .lil-title:before {
  font-family: "lil-gui";
  content: "▾";
  padding-right: 2px;
  display: inline-block;
}
.lil-gui .lil-title:active {
  background: var(--title-background-color);
  opacity: 0.75;
}
@media (hover: hover) {
  body:not(.lil-dragging) .lil-gui .lil-title:hover {
    background: var(--title-background-color);
    opacity: 0.85;
  }
  .lil-gui .lil-title:focus {
    text-decoration: underline var(--focus-color);
  }
}
.lil-gui.lil-root > .lil-title:focus {
  text-decoration: none !important;
}
.lil-gui.lil-closed > .lil-title:before {
  content: "▸";
}
.lil-gui.lil-closed > .lil-children {
  transform: translateY(-7px);
  opacity: 0;
}
.lil-gui.lil-closed:not(.lil-transition) > .lil-children {
  display: none;
}
.lil-gui.lil-transition > .lil-children {
  transition-duration: 300ms;
  transition-property: height, opacity, transform;
  transition-timing-function: cubic-bezier(0.2, 0.6, 0.35, 1);
  overflow: hidden;
  pointer-events: none;
}
.lil-gui .lil-children:empty:before {
  content: "Empty";
  padding: 0 var(--padding);
  margin: var(--spacing) 0;
  display: block;
  height: var(--widget-height);
  font-style: italic;
  line-height: var(--widget-height);
  opacity: 0.5;
}
.lil-gui.lil-root > .lil-children > .lil-gui > .lil-title {
  border: 0 solid var(--widget-color);
  border-width: 1px 0;
  transition: border-color 300ms;
}
.lil-gui.lil-root > .lil-children > .lil-gui.lil-closed > .lil-title {
  border-bottom-color: transparent;
}
.lil-gui + .lil-controller {
  border-top: 1px solid var(--widget-color);
  margin-top: 0;
  padding-top: var(--spacing);
}
.lil-gui .lil-gui .lil-gui > .lil-title {
  border: none;
}
.lil-gui .lil-gui .lil-gui > .lil-children {
  border: none;
  margin-left: var(--folder-indent);
  border-left: 2px solid var(--widget-color);
}
.lil-gui .lil-gui .lil-controller {
  border: none;
}

.lil-gui label, .lil-gui input, .lil-gui button {
  -webkit-tap-highlight-color: transparent;
}
.lil-gui input {
  border: 0;
  outline: none;
  font-family: var(--font-family);
  font-size: var(--input-font-size);
  border-radius: var(--widget-border-radius);
  height: var(--widget-height);
  background: var(--widget-color);
  color: var(--text-color);
  width: 100%;
}
@media (hover: hover) {
  .lil-gui input:hover {
    background: var(--hover-color);
  }
  .lil-gui input:active {
    background: var(--focus-color);
  }
}
.lil-gui input:disabled {
  opacity: 1;
}
.lil-gui input[type=text],
.lil-gui input[type=number] {
  padding: var(--widget-padding);
  -moz-appearance: textfield;
}
.lil-gui input[type=text]:focus,
.lil-gui input[type=number]:focus {
  background: var(--focus-color);
}
.lil-gui input[type=checkbox] {
  appearance: none;
  width: var(--checkbox-size);
  height: var(--checkbox-size);
  border-radius: var(--widget-border-radius);
  text-align: center;
  cursor: pointer;
}
.lil-gui input[type=checkbox]:checked:before {
  font-family: "lil-gui";
  content: "✓";
  font-size: var(--checkbox-size);
  line-height: var(--checkbox-size);
}
@media (hover: hover) {
  .lil-gui input[type=checkbox]:focus {
    box-shadow: inset 0 0 0 1px var(--focus-color);
  }
}
.lil-gui button {
  outline: none;
  cursor: pointer;
  font-family: var(--font-family);
  font-size: var(--font-size);
  color: var(--text-color);
  width: 100%;
  border: none;
}
.lil-gui .lil-controller button {
  height: var(--widget-height);
  text-transform: none;
  background: var(--widget-color);
  border-radius: var(--widget-border-radius);
}
@media (hover: hover) {
  .lil-gui .lil-controller button:hover {
    background: var(--hover-color);
  }
  .lil-gui .lil-controller button:focus {
    box-shadow: inset 0 0 0 1px var(--focus-color);
  }
}
.lil-gui .lil-controller button:active {
  background: var(--focus-color);
}

@font-face {
  font-family: "lil-gui";
  src: url("data:application/font-woff2;charset=utf-8;base64,d09GMgABAAAAAALkAAsAAAAABtQAAAKVAAEAAAAAAAAAAAAAAAAAAAAAAAAAAAAAHFQGYACDMgqBBIEbATYCJAMUCwwABCAFhAoHgQQbHAbIDiUFEYVARAAAYQTVWNmz9MxhEgodq49wYRUFKE8GWNiUBxI2LBRaVnc51U83Gmhs0Q7JXWMiz5eteLwrKwuxHO8VFxUX9UpZBs6pa5ABRwHA+t3UxUnH20EvVknRerzQgX6xC/GH6ZUvTcAjAv122dF28OTqCXrPuyaDER30YBA1xnkVutDDo4oCi71Ca7rrV9xS8dZHbPHefsuwIyCpmT7j+MnjAH5X3984UZoFFuJ0yiZ4XEJFxjagEBeqs+e1iyK8Xf/nOuwF+vVK0ur765+vf7txotUi0m3N0m/84RGSrBCNrh8Ee5GjODjF4gnWP+dJrH/Lk9k4oT6d+gr6g/wssA2j64JJGP6cmx554vUZnpZfn6ZfX2bMwPPrlANsB86/DiHjhl0OP+c87+gaJo/gY084s3HoYL/ZkWHTRfBXvvoHnnkHvngKun4KBE/ede7tvq3/vQOxDXB1/fdNz6XbPdcr0Vhpojj9dG+owuSKFsslCi1tgEjirjXdwMiov2EioadxmqTHUCIwo8NgQaeIasAi0fTYSPTbSmwbMOFduyh9wvBrESGY0MtgRjtgQR8Q1bRPohn2UoCRZf9wyYANMXFeJTysqAe0I4mrherOekFdKMrYvJjLvOIUM9SuwYB5DVZUwwVjJJOaUnZCmcEkIZZrKqNvRGRMvmFZsmhP4VMKCSXBhSqUBxgMS7h0cZvEd71AWkEhGWaeMFcNnpqyJkyXgYL7PQ1MoSq0wDAkRtJIijkZSmqYTiSImfLiSWXIZwhRh3Rug2X0kk1Dgj+Iu43u5p98ghopcpSo0Uyc8SnjlYX59WUeaMoDqmVD2TOWD9a4pCRAzf2ECgwGcrHjPOWY9bNxq/OL3I/QjwEAAAA=") format("woff2");
}`;function g1(i){let t=document.createElement("style");t.innerHTML=i;let e=document.querySelector("head link[rel=stylesheet], head style");e?document.head.insertBefore(t,e):document.head.appendChild(t)}var vx=!1,_c=class i{constructor({parent:t,autoPlace:e=t===void 0,container:n,width:s,title:r="Controls",closeFolders:o=!1,injectStyles:a=!0,touchStyles:l=!0}={}){if(this.parent=t,this.root=t?t.root:this,this.children=[],this.controllers=[],this.folders=[],this._closed=!1,this._hidden=!1,this.domElement=document.createElement("div"),this.domElement.classList.add("lil-gui"),this.$title=document.createElement("button"),this.$title.classList.add("lil-title"),this.$title.setAttribute("aria-expanded",!0),this.$title.addEventListener("click",()=>this.openAnimated(this._closed)),this.$title.addEventListener("touchstart",()=>{},{passive:!0}),this.$children=document.createElement("div"),this.$children.classList.add("lil-children"),this.domElement.appendChild(this.$title),this.domElement.appendChild(this.$children),this.title(r),this.parent){this.parent.children.push(this),this.parent.folders.push(this),this.parent.$children.appendChild(this.domElement);return}this.domElement.classList.add("lil-root"),l&&this.domElement.classList.add("lil-allow-touch-styles"),!vx&&a&&(g1(m1),vx=!0),n?n.appendChild(this.domElement):e&&(this.domElement.classList.add("lil-auto-place","autoPlace"),document.body.appendChild(this.domElement)),s&&this.domElement.style.setProperty("--width",s+"px"),this._closeFolders=o}add(t,e,n,s,r){if(Object(n)===n)return new Cf(this,t,e,n);let o=t[e];switch(typeof o){case"number":return new Rf(this,t,e,n,s,r);case"boolean":return new Ef(this,t,e);case"string":return new If(this,t,e);case"function":return new Ta(this,t,e)}console.error(`gui.add failed
	property:`,e,`
	object:`,t,`
	value:`,o)}addColor(t,e,n=1){return new Af(this,t,e,n)}addFolder(t){let e=new i({parent:this,title:t});return this.root._closeFolders&&e.close(),e}load(t,e=!0){return t.controllers&&this.controllers.forEach(n=>{n instanceof Ta||n._name in t.controllers&&n.load(t.controllers[n._name])}),e&&t.folders&&this.folders.forEach(n=>{n._title in t.folders&&n.load(t.folders[n._title])}),this}save(t=!0){let e={controllers:{},folders:{}};return this.controllers.forEach(n=>{if(!(n instanceof Ta)){if(n._name in e.controllers)throw new Error(`Cannot save GUI with duplicate property "${n._name}"`);e.controllers[n._name]=n.save()}}),t&&this.folders.forEach(n=>{if(n._title in e.folders)throw new Error(`Cannot save GUI with duplicate folder "${n._title}"`);e.folders[n._title]=n.save()}),e}open(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),this.domElement.classList.toggle("lil-closed",this._closed),this}close(){return this.open(!1)}_setClosed(t){this._closed!==t&&(this._closed=t,this._callOnOpenClose(this))}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}openAnimated(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),requestAnimationFrame(()=>{let e=this.$children.clientHeight;this.$children.style.height=e+"px",this.domElement.classList.add("lil-transition");let n=r=>{r.target===this.$children&&(this.$children.style.height="",this.domElement.classList.remove("lil-transition"),this.$children.removeEventListener("transitionend",n))};this.$children.addEventListener("transitionend",n);let s=t?this.$children.scrollHeight:0;this.domElement.classList.toggle("lil-closed",!t),requestAnimationFrame(()=>{this.$children.style.height=s+"px"})}),this}title(t){return this._title=t,this.$title.textContent=t,this}reset(t=!0){return(t?this.controllersRecursive():this.controllers).forEach(n=>n.reset()),this}onChange(t){return this._onChange=t,this}_callOnChange(t){this.parent&&this.parent._callOnChange(t),this._onChange!==void 0&&this._onChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(t){this.parent&&this.parent._callOnFinishChange(t),this._onFinishChange!==void 0&&this._onFinishChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onOpenClose(t){return this._onOpenClose=t,this}_callOnOpenClose(t){this.parent&&this.parent._callOnOpenClose(t),this._onOpenClose!==void 0&&this._onOpenClose.call(this,t)}destroy(){this.parent&&(this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.folders.splice(this.parent.folders.indexOf(this),1)),this.domElement.parentElement&&this.domElement.parentElement.removeChild(this.domElement),Array.from(this.children).forEach(t=>t.destroy())}controllersRecursive(){let t=Array.from(this.controllers);return this.folders.forEach(e=>{t=t.concat(e.controllersRecursive())}),t}foldersRecursive(){let t=Array.from(this.folders);return this.folders.forEach(e=>{t=t.concat(e.foldersRecursive())}),t}};function yx(i,t){let{values:e,defaults:n}=i,s=t!==""&&t in(e??{}),r=e&&n?(s?[t]:Object.keys(e)).map(u=>[e[u],n[u]]):[[i.value,i.default]],[,o]=r[0],a=r.every(([,u])=>wo(u)===wo(o)),l=!!n&&r.some(([u,d])=>d===null&&u!==null),c=!l&&r.some(([u,d])=>wo(u)!==wo(d)),h=wo(o);return l?{changed:c,title:"A piece of a cut rope has no value of the scene's"}:a?{changed:c,title:`Back to ${h||"the scene's"} ${wi(i.unit)}`.trim()}:{changed:c,title:"Back to each rope's own"}}function wo(i){return i==null?"":typeof i=="number"?String(Number(i.toPrecision(6))):Array.isArray(i)?`[${i.map(wo).join(", ")}]`:String(i)}var Pf=1e3,x1=9,_x=ns,wc=class extends _x{constructor(t,e,n){super(t,e,"value","quantity"),this.parameter=n,this.refused=s=>{},this.sliding=!1,this.slider=z("input",{type:"range",min:"0",max:String(Pf),step:"1","aria-label":n.label,oninput:()=>{this.sliding=!0,this.setValue(Y0(this.scale,Number(this.slider.value)/Pf))},onchange:()=>{this.sliding=!1,this._callOnFinishChange()}}),this.field=z("input",{type:"text",inputMode:"decimal",spellcheck:!1,autocomplete:"off","aria-label":`${n.label} [${n.unit}]`,onchange:()=>this.commit(),onblur:()=>this.updateDisplay(),onkeydown:s=>{s.key==="Enter"&&this.commit()}}),this.$widget.append(this.slider,this.field),this.updateDisplay()}get scale(){let{low:t,high:e,scale:n,kind:s}=this.parameter;return{low:t,high:e,scale:n,whole:s==="whole"}}commit(){let t=this.getValue(),e=t!==null&&this.field.value===_o(t),n=e?t:Ws(this.field.value);if(Number.isFinite(n)&&n!==t){this.setValue(n);return}this.refused(e?"":$s(this.field.value,wi(this.parameter.unit))),this.updateDisplay()}updateDisplay(){let t=this.getValue();this.sliding||(this.slider.value=String(t===null?0:Pf*K0(this.scale,t)));let e=t===null?"":_o(t);(document.activeElement!==this.field||this.sliding)&&(this.field.value=e,this.field.placeholder=t===null?"differ":"");let n=t===null?"":String(t);return this.field.toggleAttribute("title",e!==n),e!==n&&(this.field.title=n),this}disable(t=!0){return this.slider.disabled=this.field.disabled=t,super.disable(t)}},bc=class extends _x{constructor(t,e,n){super(t,e,"value","vector"),this.refused=s=>{},this.unit=wi(n.unit),this.fields=["x","y","z"].map(s=>z("input",{type:"text",inputMode:"decimal",spellcheck:!1,autocomplete:"off","aria-label":`${n.label} ${s} [${n.unit}]`,onchange:()=>this.commit(),onblur:()=>this.updateDisplay(),onkeydown:r=>{r.key==="Enter"&&this.commit()}})),this.$widget.append(...this.fields),this.updateDisplay()}commit(){let t=this.getValue()??[],e=this.fields.map(({value:r},o)=>r===this.text(t[o])?t[o]:Ws(r));if(e.every(Number.isFinite)){this.setValue(e);return}let s=this.fields.map(({value:r})=>r).map(r=>$s(r,this.unit));this.refused(s.find(Boolean)??""),this.updateDisplay()}updateDisplay(){let t=this.getValue()??["","",""];return this.fields.forEach((e,n)=>{document.activeElement!==e&&(e.value=this.text(t[n]),e.title=`${"xyz"[n]}: ${t[n]}`)}),this}text(t){return typeof t=="number"?_o(t,x1):""}disable(t=!0){for(let e of this.fields)e.disabled=t;return super.disable(t)}};function wx(i,t){let{value:e}=t;t.value=e??!1;let n=i.add(t,"value"),s=n.updateDisplay.bind(n);return n.updateDisplay=()=>(s(),n.$input.indeterminate=t.value===null,n),t.value=e,n}var Mc=class{constructor(t,e){this.session=t,this.host=e,this.gui=null,this.rows=new Map,this.queue=new Map,this.asked=new Set,this.rope="",this.built="",this.closed=new Map,t.on("parameters",n=>this.build(n))}build(t){let e=JSON.stringify(t.map(n=>[n.name,n.kind,n.unit,n.choices,n.group,n.more,n.label,Object.keys(n.values??{})]));e===this.built&&this.gui?this.refresh(t):this.rebuild(t,e)}rebuild(t,e){let n=this.host.scrollTop;this.built=e,this.gui?.destroy(),this.rows.clear(),this.gui=new _c({container:this.host,injectStyles:!1,title:"Change it while it runs"});let s=[...new Set(t.flatMap(o=>Object.keys(o.values??{})))];s.includes(this.rope)||(this.rope=""),s.length>1&&this.addRopeChoice(this.gui,s);for(let o of t)o.more||this.addRow(this.gui,o);let r=t.filter(({more:o})=>o);if(r.length){let o=this.addFolder(this.gui,"More",!0);for(let a of[...new Set(r.map(l=>l.group))]){let l=this.addFolder(o,a,a==="Air"||a.endsWith("ground"));for(let c of r)c.group===a&&this.addRow(l,c)}}this.host.scrollTop=n}addFolder(t,e,n){let s=t.addFolder(e);return s.onOpenClose(r=>{r===s&&this.closed.set(e,s._closed)}),(this.closed.get(e)??n)&&s.close(),s}addRopeChoice(t,e){let n=Object.fromEntries([["all ropes",""],...e.map(s=>[s,s])]);t.add(this,"rope",n).name("Change").onChange(()=>this.refresh(this.session.parameters))}addRow(t,e){let n={value:this.valueOf(e)},s;if(e.kind==="choice"){let c=(e.choices??[]).map(({value:h,label:u})=>[u,h]);s=t.add(n,"value",Object.fromEntries(c))}else e.kind==="flag"?s=wx(t,n):e.kind==="vector"?s=new bc(t,n,e):s=new wc(t,n,e);let r=wi(e.unit),o=z("button",{type:"button",className:"back",onclick:()=>this.set(e.name,null)},bi("undo")),a=z("div",{className:"fault",hidden:!0,role:"alert"});s.name(""),s.$name.append(z("span",{},e.label),r&&z("em",{},r),o),s.domElement.append(a),s.domElement.dataset.parameter=e.name,s.refused=c=>this.fault(e.name,c),s.onChange(c=>this.set(e.name,c));let l={parameter:e,holder:n,controller:s,back:o,fault:a};this.rows.set(e.name,l),this.show(l)}valueOf(t){return this.rope&&t.values&&this.rope in t.values?t.values[this.rope]:t.value}show(t){let{parameter:e,controller:n,holder:s,back:r}=t;t.controller.parameter=e,s.value=this.valueOf(e),n.updateDisplay(),n.disable(!e.enabled);let{changed:o,title:a}=yx(e,this.rope);r.classList.toggle("unused",!o),r.disabled=!o||!e.enabled,r.title=a,r.setAttribute("aria-label",`${e.label}: back to the scene's value`),n.domElement.title=e.enabled?e.help:e.why||e.help}refresh(t){for(let e of t){let n=this.rows.get(e.name);n&&(n.parameter=e,this.busy(e.name)||this.show(n))}}busy(t){return this.queue.has(t)||this.asked.has(t)||this.rows.get(t)?.controller.sliding}set(t,e){this.queue.size||requestAnimationFrame(()=>this.flush()),this.queue.set(t,e)}flush(){for(let[t,e]of this.queue)this.asked.has(t)||(this.queue.delete(t),this.send(t,e))}async send(t,e){let n=this.rows.get(t);this.asked.add(t);try{let o=this.rope&&n?.parameter.values?this.rope:null;await this.session.ask({type:"set",name:t,value:e,rope:o}),this.fault(t,"")}catch(o){this.fault(t,v1(o,t))}if(this.asked.delete(t),this.queue.has(t)){this.flush();return}let s=this.rows.get(t),r=this.session.parameters.find(o=>o.name===t);s&&r&&!s.controller.sliding&&(s.parameter=r,this.show(s))}fault(t,e){let n=this.rows.get(t);n&&(n.fault.hidden=e==="",n.fault.textContent=e)}};function v1({text:i,faults:t},e){if(t?.length!==1||t[0].path!==e)return i;let[{value:n,rule:s}]=t;return n===null?s:`${n}: ${s}`}var Sc=class{constructor(t,e){this.viewport=t;let n=(s,r)=>z("button",{type:"button",className:"plain letter",id:`view-${s.toLowerCase()}`,title:`Look along the ${s.toLowerCase()} axis; again: from the other side`,"aria-label":`Look along the ${s.toLowerCase()} axis`,onclick:()=>this.along(r)},s);e.append(this.bar=z("div",{className:"toolbar views",role:"toolbar","aria-label":"View"},wn("fit","Show everything",()=>t.fit(),{key:"F",id:"view-fit"}),n("X",0),n("Y",1),n("Z",2),z("button",{type:"button",className:"plain letter",id:"view-home",title:"The first view","aria-label":"The first view",onclick:()=>this.home()},"3D"))),this.bar.append(Nl(this.bar,"All views"))}along(t){let{camera:e}=this.viewport,n=t===1&&Math.abs(e.up[1])<.9?-1:1,s=e.along(t,n),r=Math.abs(e.toward[t]-n)<.001;this.viewport.fit(r?e.along(t,n===1?-1:1):s)}home(){let{layout:t}=this.viewport.session;t&&this.viewport.fly(this.viewport.framing.first(t))}};var Er=class{constructor(t){this.shown=new Float32Array(t),this.from=new Float32Array(t),this.to=new Float32Array(t),this.arrival=0,this.spacing=1e3/60,this.part=1,this.empty=!0}next(t,e=!1){let n=t-this.arrival;return this.arrival=t,this.empty||e?(this.empty=!1,this.part=1-1e-9,this.arrival=-1/0,this.to):(n<250&&(this.spacing+=.15*(Math.max(4,n)-this.spacing)),this.from.set(this.shown),this.part=0,this.to)}advance(t){if(this.empty||this.part>=1)return!1;this.part=Math.min(1,Math.max(this.part,(t-this.arrival)/this.spacing));let{shown:e,from:n,to:s,part:r}=this;if(r>=1)e.set(s);else for(let o=0;o<e.length;o++)e[o]=n[o]+r*(s[o]-n[o]);return!0}};var Lf=28*Math.PI/180,y1=.72,_1=.35,w1=.68,Ec=Math.PI/2,Tc=class i{constructor(){this.width=1,this.height=1,this.pose={target:[0,0,0],distance:5,azimuth:-Ec+.5,elevation:.22},this.view=new Float32Array(16),this.projection=new Float32Array(16),this.version=0,this.up=[0,0,1],this.first=[1,0,0],this.second=[0,1,0],this.light=[0,0,1],this.eye=[0,0,0],this.right=[1,0,0],this.top=[0,0,1],this.toward=[0,-1,0],this.update()}setUp(t){this.up=Tn(t);let e=Math.abs(this.up[0])<.9?[1,0,0]:[0,0,1];this.first=Tn($t(e,Dt(this.up,Ht(e,this.up)))),this.second=pn(this.up,this.first);let n=lt(Dt(this.first,-.45),this.second,-.55);this.light=Tn(lt(n,this.up)),this.update()}resize(t,e){this.width=Math.max(1,t),this.height=Math.max(1,e),this.update()}set(t){let e={...this.pose,...t},{target:n,distance:s,azimuth:r,elevation:o}=e;[...n,s,r,o].every(Number.isFinite)&&(this.pose=e,this.pose.elevation=Math.min(Ec,Math.max(-Ec,this.pose.elevation)),this.pose.distance=Math.min(1e7,Math.max(1e-4,this.pose.distance)),this.update())}update(){let{target:t,distance:e,azimuth:n,elevation:s}=this.pose,[r,o]=[Math.cos(n),Math.sin(n)],[a,l]=[Math.cos(s),Math.sin(s)],c=lt(Dt(this.first,r),this.second,o);this.toward=lt(Dt(c,a),this.up,l),this.right=lt(Dt(this.first,-o),this.second,r),this.top=pn(this.toward,this.right),this.eye=lt(t,this.toward,e);let h=[this.right,this.top,this.toward];for(let p=0;p<3;p++){for(let x=0;x<3;x++)this.view[4*x+p]=h[p][x];this.view[12+p]=-Ht(h[p],this.eye),this.view[4*p+3]=0}this.view[15]=1;let u=e*.01,d=e*200,f=1/Math.tan(Lf/2);this.projection.fill(0),this.projection[0]=f*this.height/this.width,this.projection[5]=f,this.projection[10]=(d+u)/(u-d),this.projection[11]=-1,this.projection[14]=2*d*u/(u-d),this.version++}get focal(){return this.height/2/Math.tan(Lf/2)}project(t,e,n){let s=this.view,r=-(s[2]*t+s[6]*e+s[10]*n+s[14]),o=this.focal/Math.max(r,1e-9);return[this.width/2+(s[0]*t+s[4]*e+s[8]*n+s[12])*o,this.height/2-(s[1]*t+s[5]*e+s[9]*n+s[13])*o,r]}eyeHeight(t){return Ht(this.eye,this.up)-t}ray(t,e){let n=(t-this.width/2)/this.focal,s=(this.height/2-e)/this.focal;return lt(lt(Dt(this.toward,-1),this.right,n),this.top,s)}inPlane(t,e,n){let s=Ht($t(this.eye,n),this.toward);return lt(this.eye,this.ray(t,e),s)}onPlane(t,e,n,s){let r=this.ray(t,e);return s<0||Math.abs(r[s])<_1?this.inPlane(t,e,n):lt(this.eye,r,(n[s]-this.eye[s])/r[s])}orbit(t,e){let n=1.2*Math.PI/Math.min(this.width,this.height);this.set({azimuth:this.pose.azimuth-t*n,elevation:this.pose.elevation+e*n})}pan(t,e){let n=this.pose.distance/this.focal,s=lt(lt(this.pose.target,this.right,-t*n),this.top,e*n);this.set({target:s})}zoom(t,e=this.width/2,n=this.height/2){let s=this.inPlane(e,n,this.pose.target);this.set({distance:this.pose.distance*t});let r=this.inPlane(e,n,this.pose.target);this.set({target:lt(this.pose.target,$t(s,r))})}at(t){let e=new i;return e.setUp(this.up),e.resize(this.width,this.height),e.set({...this.pose,...t}),e}fitted(t,e={},n){let s=Array.from({length:8},(r,o)=>be([0,1,2].map(a=>o>>a&1?t.high[a]:t.low[a])));return this.framed(s,e,n)}framed(t,e={},{top:n,bottom:s,left:r=0,right:o=0}={top:0,bottom:0}){let a=this.at({...e,target:[0,0,0],distance:1}),l=Math.tan(Lf/2),c=Math.max(.3,1-(n+s)/this.height),h=l*w1*c,u=l*y1*Math.max(.3*this.width,this.width-r-o)/this.height,[d,f,p,x]=[-1/0,-1/0,-1/0,-1/0],[g,m]=[-1/0,1/0];for(let A of t){let[U,N,P]=[a.right,a.top,a.toward].map(G=>Ht(A,G));d=Math.max(d,U+u*P),f=Math.max(f,u*P-U),p=Math.max(p,N+h*P),x=Math.max(x,h*P-N),g=Math.max(g,P),m=Math.min(m,P)}let v=Math.max((d+f)/(2*u),(p+x)/(2*h),g+.001),M=(g+m)/2,w=v-M,R=(n-s)/2*(w/this.focal),T=(r-o)/2*(w/this.focal),y=lt(lt(Dt(a.right,(d-f)/2-T),a.top,(p-x)/2+R),a.toward,M);return{...a.pose,target:y,distance:w}}along(t,e=1){let n=[0,0,0];return n[t]=e,this.angles(n)}angles(t){let e=Ht(t,this.up),n=Ht(t,this.first),s=Ht(t,this.second);return{azimuth:Math.hypot(n,s)>1e-6?Math.atan2(s,n):-Ec,elevation:Math.atan2(e,Math.hypot(n,s))}}};var b1=320,Ac=class{constructor(t,e,n,s=b1){this.duration=s;let r=e.azimuth-t.azimuth;this.from=t,this.to=e,this.turn=r-2*Math.PI*Math.round(r/(2*Math.PI)),this.start=n}at(t){let e=Math.min(1,Math.max(0,(t-this.start)/this.duration)),n=e*e*(3-2*e),{from:s,to:r}=this;return{over:e>=1,pose:{target:lt(s.target,$t(r.target,s.target),n),distance:s.distance*(r.distance/s.distance)**n,azimuth:s.azimuth+n*this.turn,elevation:s.elevation+n*(r.elevation-s.elevation)}}}};var M1=.28,S1=1e4,E1=3e38;function bx(i,t,{center:e,radius:n}){let[s,r,o]=e,a=S1*n,l=h=>!(Math.abs(i[h]-s)<a&&Math.abs(i[h+1]-r)<a&&Math.abs(i[h+2]-o)<a),c=null;for(let h=0,u=0;h<t;h++,u+=4){if(!l(u)){Number.isFinite(i[u+3])||(i[u+3]=0);continue}if(h>0)c=i.subarray(u-4,u-1);else{let d=0;for(;d<t&&l(4*d);)d++;c=d<t?i.slice(4*d,4*d+3):e}i.set(c,u),i[u+3]=E1}}function Rc(i,t){let e={low:[1/0,1/0,1/0],high:[-1/0,-1/0,-1/0]};for(let n=0;n<t;n++)for(let s=0;s<3;s++){let r=i[4*n+s];r<e.low[s]&&(e.low[s]=r),r>e.high[s]&&(e.high[s]=r)}return e}function Mx(i,t,e){let n=[0,1,2].filter(r=>i.high[r]-i.low[r]<1e-4*e);if(!n.length)return-1;let s=n.filter(r=>Math.abs(t[r])<.9);return s.length>1?s.includes(1)?1:s[s.length-1]:s.length?s[0]:n[0]}var Sx=(i,t,e)=>i>=0&&Math.abs(t[i])>.9&&e.some(n=>n!==0);function Ex(i,t,e=!1,n=!1){if(t<0)return{azimuth:-Math.PI/2+.55,elevation:n?.62:.3};if(Math.abs(i.up[t])>.9)return{azimuth:-Math.PI/2,elevation:Math.PI/2};let s=be([0,0,0]);s[t]=1;let r=Ht(pn(i.up,s),[1,1,1])>=0?1:-1,{azimuth:o}=i.along(t,r);return{azimuth:o-(e?1.6:1)*M1,elevation:e?.24:.14}}function Tx(i,{level:t,given:e}){let n=Hm(i.pose.distance*.28/5),{target:s}=i.pose,r=Math.round(Ht(s,i.first)/n)*n,o=Math.round(Ht(s,i.second)/n)*n,a=lt(lt(Dt(i.first,r),i.second,o),i.up,t);return{height:t,solid:e!==null,spacing:n,radius:14*n,center:a}}var T1=["background","horizon","grid","shadow","ground","anchor","hand","load","arrow","grab","pin","hover","node","post","body","joint","contact"],Ax="ropewalk-theme";function Rx(){let i=new URLSearchParams(location.search).get("theme")??A1();return i==="light"||i==="dark"?i:matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"}function A1(){try{return localStorage.getItem(Ax)}catch{return null}}function Cc(i,t=!1){if(document.documentElement.dataset.theme=i,!!t)try{localStorage.setItem(Ax,i)}catch{}}function Nf(){let i=document.documentElement.dataset.theme==="dark",t=getComputedStyle(document.documentElement);return{...Object.fromEntries(T1.map(n=>[n,gr(t.getPropertyValue(`--scene-${n}`).trim()||"#888888")])),rim:ig(i),dark:i}}function Tr(i){let t=Math.max(1,Math.min(1024,i));return[t,Math.max(1,Math.ceil(i/t))]}function R1(i,t){return t==="strain"?i.EA?1/i.EA:0:t==="utilisation"?i.breaking_load?1/i.breaking_load:0:1}function Cx(i,t,e,n,s){let r=0,[o,a]=[1/0,-1/0],l=t.variants.map(()=>[]);return t.variants.forEach((c,h)=>{let u=i.parts[h],[d,f,p]=n[h],{positions:x}=u;for(let g=0,m=0,v=r;g<c.nodes;g++,m+=3,v+=4)s[v]=x[m]+d,s[v+1]=x[m+1]+f,s[v+2]=x[m+2]+p;if(e==="speed"){let g=Be(t,u,"speed_high"),{greatestSpeed:m}=u.seen;for(let v=0;v<c.nodes;v++)s[r+4*v+3]=m[v]/65535*g;o=0,a=Math.max(a,g)}else if(e!=="plain"){let g=Be(t,u,"tension_low"),m=(Be(t,u,"tension_high")-g)/65535;for(let v of c.ropes){let M=R1(v,e),w=v.first+v.nodes-1,{greatestTension:R,leastTension:T}=u.seen,y=R[v.first],[A,U]=[1/0,-1/0];for(let N=v.first;N<=w;N++){let P=N<w?R[N]:y;s[r+4*N+3]=(g+m*.5*(y+P))*M,y=P,U=Math.max(U,P),N<w&&(A=Math.min(A,T[N]))}o=Math.min(o,(g+m*A)*M),a=Math.max(a,(g+m*U)*M),l[h].push(g+m*U)}}r+=4*c.nodes}),e==="utilisation"?{low:0,high:Math.max(1,a),tensions:l}:{low:o,high:a,tensions:l}}function Ix(i,t,e){let n=0;i.parts.forEach((s,r)=>{for(let o=0;o<s.anchors.length;o+=10)for(let a=0;a<3;a++)e[n++]=s.anchors[o+a]+t[r][a]})}var Ic=2,C1=.5,I1=.3,P1=.1,L1=4,N1=5e3,D1=300,Pc=.95,O1=.75,F1=.92,U1=3,k1=48,B1=1.05,z1=16,H1=6,V1=.02,G1=.3,Lc=class{constructor(){this.low=[1/0,1/0,1/0],this.high=[-1/0,-1/0,-1/0],this.angles="",this.clock=0,this.past=[],this.speeds={low:[0,0,0],high:[0,0,0]},this.now=null,this.along=0,this.drawn=null,this.still=[],this.beyond={low:[0,0,0],high:[0,0,0]},this.patience=0,this.large=0,this.nearer=!1}clear(){this.low.fill(1/0),this.high.fill(-1/0),this.past=[],this.speeds={low:[0,0,0],high:[0,0,0]},this.now=null,this.along=0,this.drawn=null,this.still=[],this.patience=this.large=0,this.nearer=!1}take(t,e,n,s,r){let o=`${t.pose.azimuth} ${t.pose.elevation}`;o!==this.angles&&this.clear(),this.angles=o;let a=Lx(t,e,n,r),{low:l,high:c}=a;this.clock+=s;let h=this.past.at(-1);if(this.past=this.past.filter(({time:p})=>this.clock-p<Ic),![...l,...c].every(Number.isFinite)){this.past.length||this.clear();return}h&&s>0&&this.learn(h,a,s),this.past.push({time:this.clock,...a}),this.now={...a,low:[...l],high:[...c]};let u=this.goAlong(n[0]?.adrift??!1,h,a),d=I1*this.size,f=p=>Math.min(d,C1*Math.max(0,p));for(let p=0;p<3;p++){let x=Math.min(...this.past.map(m=>m.low[p])),g=Math.max(...this.past.map(m=>m.high[p]));this.beyond.low[p]=-(l[p]>x?0:f(this.speeds.low[p]+u[p])),this.beyond.high[p]=c[p]<g?0:f(this.speeds.high[p]-u[p]),this.low[p]=x+this.beyond.low[p],this.high[p]=g+this.beyond.high[p]}this.still=[],this.drawn&&this.stayBehind(t,this.drawn,a)}stayBehind({right:t,top:e,toward:n},s,r){[t,e,n].forEach((o,a)=>{let l=this.along*(Ht(s,o)-r.middle[a]);for(let{low:c,high:h}of[this,this.beyond])c[a]+=l,h[a]+=l})}get size(){let{low:t,high:e}=this.now??this;return Math.max(...e.map((n,s)=>n-t[s]))}goAlong(t,e,n){let{low:s,high:r}=this.speeds,o=r.map((c,h)=>(c-s[h])/2),a=Math.hypot(...o);this.along=t&&a>0?Math.max(0,1-G1*this.size/a):0;let l=n.middle.map((c,h)=>this.along*(c-(e??n).middle[h]));for(let c of this.past)if(c!==this.past.at(-1))for(let h of[c.low,c.high])l.forEach((u,d)=>h[d]+=u);return o.map(c=>this.along*c)}goes(t,e,n,s){let{right:r,top:o,toward:a}=t,l=this.drawn;if(this.drawn=null,!this.along)return[0,0,0];let c=Lx(t,e,n,s),[h,u,d]=c.middle;return Number.isFinite(h+u+d)?(this.now=c,this.drawn=lt(lt(Dt(r,h),o,u),a,d),l?Dt($t(this.drawn,l),this.along):[0,0,0]):[0,0,0]}get rests(){let{past:t,size:e}=this,n=r=>[0,1,2].some(o=>{let a=t.map(l=>l[r][o]);return Math.max(...a)-Math.min(...a)>V1*e});return t.length>0&&this.clock-t[0].time>.8*Ic&&!n("low")&&!n("high")}learn(t,e,n){let s=Math.min(1,n/P1),{low:r,high:o}=this.speeds;for(let a=0;a<3;a++)r[a]+=s*((t.low[a]-e.low[a])/n-r[a]),o[a]+=s*((e.high[a]-t.high[a])/n-o[a])}hold({right:t,top:e,toward:n},s){this.still=s,[t,e,n].forEach((r,o)=>{for(let a of s){let l=Ht(a,r);this.low[o]=Math.min(this.low[o],l),this.high[o]=Math.max(this.high[o],l)}})}box(t){let e=this.corners(t),[n,s]=[Math.min,Math.max].map(r=>be([0,1,2].map(o=>r(...e.map(a=>a[o])))));return{low:n,high:s}}wanted(t,e,n=e){let s=this.goal(t,n);if(!s)return null;let{distance:r}=t.pose,o=this.calm(s,r);return o.distance<r||this.leaves(t,e)?o:null}calm(t,e){if(t.distance>=F1*e&&(this.large=this.clock),t.distance>B1*e&&this.nearer&&(this.patience=Math.min(z1,Math.max(Ic,2*this.patience)),this.nearer=!1),t.distance>=e)return t;let n=this.clock-this.large-this.patience;return!(t.distance<O1*e||this.rests||n>=U1)||n<0||this.large===this.clock?{...t,distance:e}:(this.nearer=!0,t)}goal(t,e){return this.low.every(Number.isFinite)?t.framed(this.outline(t),{},e):null}leaves(t,e){return Px(t,this.outline(t),e)>Pc}outline(t){let e=new Map;for(let{time:s,low:r,high:o}of this.past){let a=Math.floor(s*k1/Ic),l=e.get(a)??{low:r,high:o};e.set(a,{low:r.map((c,h)=>Math.min(c,l.low[h])),high:o.map((c,h)=>Math.max(c,l.high[h]))})}let n=[...this.still];for(let{low:s,high:r}of e.values())n.push(...this.corners(t,{low:s.map((o,a)=>o+this.beyond.low[a]),high:r.map((o,a)=>o+this.beyond.high[a])}));return n}keep(t,e,n){if(!this.now)return e;let s=this.corners(t,this.now),r=e;for(let o=0;o<H1;o++){let a=t.at(r);if(Px(a,s,n)<=Pc+.001)return r;r=W1(a,s,n)}return r}corners({right:t,top:e,toward:n},{low:s,high:r}=this){return Array.from({length:8},(o,a)=>{let[l,c,h]=[0,1,2].map(u=>a>>u&1?r[u]:s[u]);return[0,1,2].map(u=>l*t[u]+c*e[u]+h*n[u])})}},Nx=({width:i,height:t},{top:e,bottom:n,left:s=0,right:r=0})=>({x:(s+i-r)/2,y:(e+t-n)/2,across:Math.max(1,(i-s-r)/2),up:Math.max(1,(t-e-n)/2)});function Px(i,t,e){let{x:n,y:s,across:r,up:o}=Nx(i,e);return Math.max(...t.map(a=>{let[l,c,h]=i.project(...a);return h>0?Math.max(Math.abs(l-n)/r,Math.abs(c-s)/o):1/0}))}function W1(i,t,e){let{pose:n}=i,s=t.map(x=>i.project(...x));if(s.some(([,,x])=>x<=0))return{...n,distance:2*n.distance};let{x:r,y:o,across:a,up:l}=Nx(i,e),c=(x,g,m)=>{let v=s.map(T=>T[x]-g),[M,w]=[Math.min(...v),Math.max(...v)];return{over:Math.max(0,w-m)+Math.min(0,M+m),tight:(w-M)/(2*m)}},[h,u]=[c(0,r,Pc*a),c(1,o,Pc*l)],d=Math.max(h.tight,u.tight);if(d>1)return{...n,distance:n.distance*d};let f=n.distance/i.focal,p=lt(lt(n.target,i.right,h.over*f),i.top,-u.over*f);return{...n,target:p}}function Lx({right:i,top:t,toward:e},n,s,{center:r,radius:o}){let a=s.reduce((d,f)=>d+f.nodes,0),l=Math.max(1,Math.ceil(a/D1)),c=[1/0,1/0,1/0],h=[-1/0,-1/0,-1/0],u=[0,0,0];return[i,t,e].forEach(([d,f,p],x)=>{let g=r[0]*d+r[1]*f+r[2]*p,m=0;for(let{first:v,nodes:M,held:w}of s){let R=(w?N1:L1)*o;for(let T=v;T<v+M;T+=l){let y=n[4*T]*d+n[4*T+1]*f+n[4*T+2]*p;Math.abs(y-g)<=R&&(y<c[x]&&(c[x]=y),y>h[x]&&(h[x]=y),u[x]+=y,m++)}}u[x]/=m}),{low:c,high:h,middle:u}}function Dx(i,t,e,n){let s=t.first+t.nodes-1,r=i.map(({index:l})=>l).filter(l=>l>=t.first&&l<=s).sort((l,c)=>l-c),o=t.length/Math.max(1,t.segments),a=1/0;return r.forEach((l,c)=>{let h=e(l),u=Ht(h,n),d=r[c+1];if(c===0&&(a=Math.min(a,u-(l-t.first)*o)),d===void 0){a=Math.min(a,u-(s-l)*o);return}let f=e(d),p=(d-l)*o,x=u-Ht(f,n),g=Math.max(0,h.reduce((v,M,w)=>v+(M-f[w])**2,0)-x*x),m=Math.sqrt(Math.max(0,p*p-g));a=Math.min(a,u,u-(x+m)/2)}),a}var $1=.12,X1=.03,q1=.1,Y1=4,Nc=class{constructor(t){this.viewport=t,this.height=0,this.goal=0}get level(){return this.given??this.height}get given(){let{session:t,solids:e}=this.viewport;return t.layout?.ground?.height??e.floor}put(t,e){let{camera:n,nodes:s,starts:r}=this.viewport,{up:o}=n,a=g=>be(s.to.subarray(4*g,4*g+3)),{solids:l}=this.viewport,h=(l.all.length?[]:t.variants).flatMap(({ropes:g,anchors:m},v)=>g.map(M=>Dx(m,M,w=>a(r[v]+w),o))),u=Math.hypot(...e.high.map((g,m)=>g-e.low[m])),d=Math.min(...[e.low,e.high].map(g=>Ht(g,o))),f=Math.min(...h,d),p=l.lowest(),x=p<f-X1*u?p:Math.min(f,p)-$1*u;Number.isFinite(x)&&(this.height=this.goal=x)}giveWay(t){if(this.given!==null)return;let{up:e}=this.viewport.camera,{to:n}=this.viewport.nodes,{center:s,radius:r}=t.view,o=1/0;for(let c=0;c<4*ti(t);c+=4)o=Math.min(o,n[c]*e[0]+n[c+1]*e[1]+n[c+2]*e[2]);let a=Ht(s,e)-Y1*r;o<this.height&&o>=a&&(this.goal=Math.min(this.goal,o-q1*r));let l=this.viewport.solids.lowest();l<this.height&&l>=a&&(this.goal=Math.min(this.goal,l))}advance(){let t=this.goal-this.height,{layout:e}=this.viewport.session;t===0||!e||(this.height+=Math.abs(t)<.003*e.view.radius?t:.08*t,this.viewport.dirty=!0)}};var Dc=class{constructor(t,e,n){this.shape=e;let s=new Int32Array(e.nodes);e.ropes.forEach(({first:r,count:o},a)=>s.fill(a,r,r+o)),this.groups=e.ropes.map((r,o)=>o),this.anchored=t.variants.map(({anchors:r},o)=>r.map(({index:a})=>s[n[o]+a])),t.variants.forEach(({joints:r},o)=>{for(let{nodes:a}of r??[])this.tie(a.map(l=>s[n[o]+l]))})}tie([t,...e]){for(let n of e)this.groups[this.group(n)]=this.group(t)}group(t){for(;this.groups[t]!==t;)t=this.groups[t];return t}held(t){let e=new Set;this.anchored.forEach((s,r)=>s.forEach((o,a)=>t(r,a)&&e.add(this.group(o))));let n=!e.size;return this.shape.ropes.map(({first:s,count:r},o)=>({first:s,nodes:r,held:n||e.has(this.group(o)),adrift:n}))}};var Ra=3.5,K1=.02,Z1=.05,Ar=class{constructor(t,e,n){this.pose=t,this.to=e,this.time=n,this.speed=[0,0,0],this.zoom=0}at(t){let e=Math.min(.5,Math.max(0,(t-this.time)/1e3));this.time=t;let{pose:n,to:s}=this,r=Math.exp(-Ra*e),o=$t(n.target,s.target),a=lt(this.speed,o,Ra);this.speed=Dt(lt(this.speed,a,-Ra*e),r);let l=lt(s.target,lt(o,a,e),r),c=Math.log(n.distance/s.distance),h=this.zoom+Ra*c;this.zoom=(this.zoom-Ra*h*e)*r;let u=s.distance*Math.exp((c+h*e)*r);return this.pose={...s,target:l,distance:u},{pose:this.pose,over:this.there}}carry(t){this.pose={...this.pose,target:lt(this.pose.target,t)},this.to={...this.to,target:lt(this.to.target,t)}}get there(){let{pose:t,to:e}=this,n=Math.hypot(...$t(t.target,e.target))/e.distance,s=Math.hypot(...this.speed)/e.distance,r=Math.abs(Math.log(t.distance/e.distance));return Math.max(n,r)<K1&&Math.max(s,Math.abs(this.zoom))<Z1}};var J1=.2,Oc=class{constructor(t){this.viewport=t,this.ropes=new Lc,this.bound=null,this.strips={top:0,bottom:0},this.looked=0}take(t,e){let{viewport:n,ropes:s}=this,{camera:r,framing:o,solids:a}=n,l=Math.min(J1,(e-this.looked)/1e3);if(this.looked=e,s.take(r,n.nodes.to,this.pieces(t),l,t.view),s.hold(r,a.places(s.box(r))),n.floor.giveWay(t),r.version!==n.ownVersion&&!n.flight&&(n.following=!1),!n.following||n.held())return;this.strips=o.now();let c=o.roomIn(d=>s.goal(r,d),this.strips),h=s.goal(r,c),{flight:u}=n;if(u instanceof Ar){let d=Math.min(u.to.distance,u.pose.distance);h&&(u.to=s.calm(h,d))}else!u&&o.losesArrow()?this.chase(h&&s.calm(h,r.pose.distance),e):u||this.chase(s.wanted(r,this.strips,c),e)}pieces(t){let{session:e,gaps:n,starts:s}=this.viewport,r=e.frame?.parts,o=(l,c)=>(r?.[l]?.anchors[10*c+9]??1)>=.5,a=n.shape(t);return this.bound?.shape!==a&&(this.bound=new Dc(t,a,s)),this.bound.held(o)}chase(t,e){let{viewport:n}=this;t&&(n.ownVersion=n.camera.version,matchMedia("(prefers-reduced-motion: reduce)").matches?n.setPose(t):n.flight=new Ar(n.camera.pose,t,e))}advance(t){let{viewport:e,ropes:n}=this,{flight:s,camera:r}=e,{layout:o}=e.session,a=o&&this.goes()?n.goes(r,e.nodes.shown,this.pieces(o),o.view):[0,0,0];s instanceof Ar?s.carry(a):a.some(h=>h!==0)&&!s&&e.setPose({...r.pose,target:lt(r.pose.target,a)});let l=s?.at(t);if(!l)return;let c=s instanceof Ar&&!e.past;c&&(s.pose=n.keep(r,l.pose,this.strips)),e.setPose(c?s.pose:l.pose),l.over&&e.land()}goes(){let{viewport:t}=this,e=t.following&&t.camera.version===t.ownVersion,n=matchMedia("(prefers-reduced-motion: reduce)").matches;return e&&!t.past&&!t.held()&&!n}};var j1=[0,.5,-.5,1,-1,1.5,-1.5,2,-2,2.5,-2.5,Math.PI];function Ox(i,t,e,n){let[s,r]=[t.azimuth,1/0];for(let o of j1){let a=t.azimuth+o,{eye:l}=i.at({...t,azimuth:a}),c=e.filter(h=>n.some(u=>fr(u,l,h,0))).length;c<r&&([s,r]=[a,c])}return s}var Q1=84,tE=.1,Uc=8,eE=.5,nE=.42,iE=1.15,sE=1.05,rE=.6,oE=14,aE=34,Fc=6,lE=.12;function Df({session:i},t){let e=i.layout,n=i.frame,s=[],r=0;return e.variants.forEach((o,a)=>{let l=n.parts[a];o.anchors.forEach((c,h)=>{let u=be(t.subarray(r,r+3));if(r+=3,l.anchors[10*h+9]<.5||!u.every(Number.isFinite))return;let d=be(l.anchors.subarray(10*h+6,10*h+9)),f=Math.hypot(...d),p=l.seen.greatestForce[h],x=Number.isFinite(p)?Math.max(f,p):f;s.push({variant:a,a:h,anchor:c,place:u,force:d,size:f,peak:x})})}),s}var Of=i=>Math.max(0,...i.map(({size:t})=>t).filter(Number.isFinite));function Fx(i,t,e){if(!(t>sE*i))return ce(e?t:i,"N");let n=`max ${ce(t,"N")}`;return e?n:`${ce(i,"N")}, ${n}`}function kc(i,t,e=new Set,n=()=>!1){let s=Bc(i),r=Math.max(0,...i.map(({peak:o})=>o).filter(Number.isFinite));return i.filter(o=>{if(o.size<1e-9)return!1;if(n(o))return!0;let a=e.has(bo(o))?nE:eE;return o.peak>=tE*t&&(!s||o.peak>=a*r)})}var Bc=i=>i.filter(({variant:t})=>t===i[0]?.variant).length>Uc;function Ux(i,t,e){let n=r=>r.peak*(t.has(bo(r))?iE:1),s=[...i].sort((r,o)=>n(o)-n(r)).slice(0,Uc);return i.filter(r=>s.includes(r)||e(r))}var bo=({variant:i,a:t})=>`${i} ${t}`,kx=({width:i,height:t})=>Math.min(Q1,.14*i,.17*t);function zc(i,t,e){let n=(t.variants[0].forces??[]).map(({force:s})=>Math.hypot(...s)/rE);return kx(e)*e.pose.distance/e.focal/Math.max(i,...n)}function Hc(i,t,e,n){let s=oE*n.pose.distance/n.focal;return lt(i,t,Math.max(e,s/Math.hypot(t[0],t[1],t[2])))}function Ff(i,t){let{session:e,anchors:n,marks:s}=i;if(!e.frame||!s.reactions)return[];let r=Df(i,n.to),o=Math.max(Of(r),s.strongest),a=kx(t)*t.pose.distance/t.focal,l=zc(o,e.layout,t),c=kc(r,o,s.arrowed).map(({place:h,force:u})=>Hc(h,u,l,t));return s.strongest||Bc(r)?c:[...c,...cE(i,r,a)]}function cE({nodes:i,starts:t,session:e},n,s){let r=e.layout?.variants[0].ropes??[];return n.flatMap(({variant:o,anchor:{index:a},place:l})=>{let c=r.find(({first:d,nodes:f})=>a===d||a===d+f-1);if(!c)return[];let h=t[o]+a+(a===c.first?1:-1),u=$t(l,i.to.subarray(4*h,4*h+3));return[lt(l,Tn(u),s)]})}function Vc(i,t,e){let n={top:0,bottom:0},s=Ff(i,t),r=(o,a)=>{for(let l of o){let[,c,h]=t.project(...l);h>0&&(n.top=Math.max(n.top,e.top+a-c),n.bottom=Math.max(n.bottom,c+a+e.bottom-t.height))}};return r(s,aE),r(cx(i,t),0),Uf({...e,...hE(i,t,s,e),top:e.top+n.top,bottom:e.bottom+n.bottom},e,t)}function Uf(i,t,{height:e}){let n=lE*(e-t.top-t.bottom);return{...i,top:Math.min(i.top,t.top+n),bottom:Math.min(i.bottom,t.bottom+n)}}function Bx(i,t,e){let n=["top","bottom","left","right"],s=n.map(o=>(t[o]??0)-(e[o]??0));if(s.every(o=>o<1))return null;let r={...i};return n.forEach((o,a)=>{s[a]>0&&(r[o]=(i[o]??0)+s[a])}),r}function hE(i,t,e,{left:n=0}){let s={left:n,right:0};for(let r of i.bars?.()??[])if(!(r.height<r.width))for(let[o,a]of e.map(l=>t.project(...l)))a<r.top-Fc||a>r.bottom+Fc||(r.left<t.width/2?s.left=Math.max(s.left,r.right+Fc-o):s.right=Math.max(s.right,o+Fc-r.left));return{...s.left?{left:s.left}:{},...s.right?{right:s.right}:{}}}function zx({anchors:i,joints:t,ropes:e},n){let s=e.find(({first:c,nodes:h})=>n>=c&&n<c+h);if(!s)return!1;let r=s.first+s.nodes-1,o=(t??[]).flatMap(({nodes:c})=>c),a=[...i.map(c=>c.index),...o],l=(c,h)=>c<=h&&!a.some(u=>u>=c&&u<=h);return l(s.first,n-1)||l(n+1,r)}var Hx=.04,uE=3,Gc=class{constructor(t){this.viewport=t,this.besideLegend=!1,this.right=!1}first(t){let{camera:e,axis:n,solids:s,lying:r}=this.viewport,o=Ex(e,n,s.all.length>0,r),a=this.clear(t,o);if(n>=0||s.all.length===0)return a;let l=Ox(e,a,[...this.ends(t)],s.all);return l===a.azimuth?a:this.clear(t,{...o,azimuth:l})}*ends(t){let{to:e}=this.viewport.nodes,n=vo(t);for(let[s,{ropes:r}]of t.variants.entries())for(let{first:o,nodes:a}of r)for(let l of[0,Hx,2*Hx]){let c=Math.round(l*(a-1));for(let h of[o+c,o+a-1-c])yield be(e.subarray(4*(n[s]+h),4*(n[s]+h)+3))}}clear(t,e){this.besideLegend=!1;let n=this.whole(t,e);return this.covered(n)?this.whole(t,e):n}whole(t,e){this.right=!1;let n=this.framed(t,e);if(!this.besideLegend||this.viewport.card())return n;this.right=!0;let s=this.framed(t,e);return this.right=s.distance<n.distance,this.right?s:n}framed(t,e){let{viewport:n}=this,s=[...this.places(t)],r=o=>n.camera.framed(s,e,o);return r(this.roomIn(r,this.strips()))}roomIn(t,e){let{viewport:n}=this,s=e;for(let r=0;r<uE;r++){let o=t(s);if(!o)return e;let a=Bx(s,Vc(n,n.camera.at(o),e),e);if(!a)return s;s=Uf(a,e,n.camera)}return s}*places(t){let{to:e}=this.viewport.nodes;for(let n=0;n<ti(t);n++)yield be(e.subarray(4*n,4*n+3));yield*this.viewport.solids.places(Rc(e,ti(t)))}covered(t){let{session:e,camera:n,nodes:s,card:r,legendCard:o}=this.viewport,{layout:a}=e;if(!a)return!1;let l=[n.at(t),s.to,ti(a)];if(pf(...l,r()))return!0;let c=pf(...l,o());return c&&(this.besideLegend=!0),c}obstructed(){let{viewport:t}=this,e=this.strips();if(this.covered(t.camera.pose))return!0;if(!t.card()&&!e.right)return!1;let{camera:n,follower:s}=t;return Vc(t,n,e).top>e.top+1||s.ropes.leaves(n,e)}losesArrow(){let{viewport:t}=this,e=this.strips(),{left:n=0}=e;if(Ff(t,t.camera).map(o=>t.camera.project(...o)[0]).some(o=>o<n||o>t.camera.width))return!0;let r=Vc(t,t.camera,e);return(r.left??0)>n||(r.right??0)>0}now(){return this.besideLegend||this.covered(this.viewport.camera.pose),this.strips()}strips(){let{card:t,legendCard:e,camera:n}=this.viewport,s=this.besideLegend?e():null;return{...(this.right&&!t()?z0(s,n):null)??mf(t()??s,n),...H0(this.viewport.bars(),n)}}};var Wc=class{constructor(t){this.viewport=t,this.now=[],this.key="",this.drawn=null}take(t,e){let n=$0(t,e),s=`${t.layout}: ${n.join("; ")}`;s!==this.key&&([this.now,this.key]=[n,s],this.drawn=gf(t,n),this.viewport.renderer.setShape(this.drawn))}shape(t){return this.drawn??gf(t)}};var $c=class{constructor(t,e){this.nodes=t,this.colours=e,this.points=new Float32Array(4*360*t.length),this.head=0,this.version=0,this.empty=!0}push(t){let e=this.empty?360:1;for(let n=0;n<e;n++)this.nodes.forEach((s,r)=>{let o=4*(r*360+this.head);for(let a=0;a<3;a++)this.points[o+a]=t[4*s+a]}),this.head=(this.head+1)%360;this.empty=!1,this.version++}clear(){this.empty=!0,this.version++}};function Vx({ground:i,obstacles:t,variants:[e]}){return!i&&!t?.length&&!e.anchors.length?e.ropes.slice(0,1).map(({first:s})=>s):[]}var Gx=Uc,dE=24,fE=12,pE=new Set(["fixed","velocity","table"]),mE=9,gE=5,xE=(i,t)=>`${ce(i,"N")}${t>0&&i>.995*t?" (no more)":""}`,Xc=class{constructor(t){this.viewport=t,this.dirty=!0,this.reactions=!0,this.contacts=!0,this.firmest=0,this.trails=null,this.followed=new Set,this.scene="",this.copy=null,this.hover=null,this.held=new Set,this.chosen=null,this.kick=null,this.tying=null,this.line=null,this.strongest=0,this.arrowed=new Set,this.numbered=new Set,this.crowd=null,this.most=[],this.labels=[],this.touches=[],this.posts=[],this.standing=!0,this.hanging=new Set}setLayout(t){let[e]=t.variants,n=t.obstacles?.length?[]:e.anchors.map(({index:r})=>r);this.hanging=new Set(n.filter(r=>zx(e,r)));let s=`${t.scene.name} ${t.scene.preset}`;s!==this.scene?this.followed=new Set(Vx(t)):this.copy&&(this.followed=eg(this.followed,this.copy,e)),[this.scene,this.copy]=[s,e],this.resetTrails(),this.strongest=this.firmest=0,this.most=[],this.hover=this.kick=this.chosen=this.tying=this.line=null}take({parts:t}){this.most=t.map(({seen:e},n)=>Array.from(e.greatestForce,(s,r)=>Math.max(s,this.most[n]?.[r]??0)))}written(){this.most=[]}toggleTrail(t){this.followed.delete(t)||this.followed.add(t),this.followed.size>8&&this.followed.delete([...this.followed][0]),this.resetTrails()}resetTrails(){let t=[...this.followed],e=t.map((n,s)=>gr(Qe[(s+1)%Qe.length]));this.trails=t.length?new $c(t,e):null,this.dirty=!0}collect(){let t=[],e=[];this.labels=[],this.posts=[],this.touches=[];let{session:n}=this.viewport;return n.layout&&n.frame&&(this.addAnchors(t,e),this.addLoads(t),this.addJoints(t),this.addForces(e),this.addContacts(),this.addGrabs(t,e),this.addHand(t,e)),{markers:t,arrows:e}}addAnchors(t,e){let{viewport:n}=this,{theme:s}=n,r=Df(n,n.anchors.shown),o=r.length>fE?12:19;for(let{place:l,anchor:c}of r){let[h,u,d]=l,f=c.pinned?s.pin:c.motion==="hand"?s.hand:s.anchor;t.push({x:h,y:u,z:d,kind:"eye",colour:f,size:0,pixels:c.pinned?Math.min(o,14):o}),pE.has(c.motion)&&!this.hanging.has(c.index)&&this.addPost(l)}if(!this.reactions)return;this.strongest=Math.max(Of(r),this.strongest*.995);let a=r.filter(({variant:l})=>l===0||n.apart);this.addReactions(a,e)}addReactions(t,e){let{camera:n,theme:s,session:r}=this.viewport,o=r.status?.playing??!1,a=zc(this.strongest,r.layout,n),l=kc(t,this.strongest,this.arrowed),c=d=>this.pointedAt(d),h=kc(t,this.strongest,this.arrowed,c),u=Ux(h,this.numbered,c);this.arrowed=new Set(l.map(bo)),this.numbered=new Set(u.map(bo)),this.crowd=Bc(t)?{forces:t.length,large:l.length}:null;for(let d of h){let{variant:f,a:p,place:x,force:g,size:m,peak:v}=d,M=Hc(x,g,a,n);if(e.push({from:x,to:M,colour:s.arrow,pixels:2.6,head:!0}),!u.includes(d))continue;let w=Math.max(v,this.most[f]?.[p]??0),R=`reaction ${bo(d)}`;this.labels.push({id:R,from:x,at:M,text:Fx(m,w,o),kind:"reaction"})}}pointedAt({variant:t,anchor:e}){return[this.hover,this.chosen].some(n=>n!==null&&!Array.isArray(n)&&n.kind==="anchor"&&n.variant===t&&n.anchor===e.name)}addPost(t){let{camera:e,theme:n,floor:s}=this.viewport,r=Ht(t,e.up)-s.level,o=gE*e.pose.distance/e.focal;if(!this.standing||r<2*o||this.posts.length>=2*dE)return;let a=mE*e.pose.distance/e.focal,l=lt(t,e.toward,-a),c=lt(l,e.up,-r),h=lt(c,e.toward,.3*o);this.posts.push({from:l,to:c,colour:n.post,pixels:4.5,head:!1},{from:lt(h,e.up,o),to:h,colour:n.post,pixels:16,head:!1})}addLoads(t){let{session:e,theme:n,nodes:s,starts:r}=this.viewport;e.layout.variants.forEach((a,l)=>{let c=a.ropes.reduce((h,u)=>h+u.mass,0);for(let h of a.loads){let u=4*(r[l]+h.index),[d,f,p]=s.shown.subarray(u,u+3),x=9+11*Math.min(1.6,Math.cbrt(h.mass/Math.max(c,1e-9)));t.push({x:d,y:f,z:p,kind:"round",colour:n.load,size:0,pixels:x})}});for(let[a,l]of[...this.followed].entries()){let[c,h,u]=s.shown.subarray(4*l,4*l+3),d=gr(Qe[(a+1)%Qe.length]);t.push({x:c,y:h,z:u,kind:"round",colour:d,size:0,pixels:8})}}addJoints(t){let{session:e,theme:n,nodes:s,starts:r,camera:o}=this.viewport,{variants:a}=e.layout,l=this.hover&&!Array.isArray(this.hover)?this.hover:null;a.forEach(({joints:c,ropes:h},u)=>{let d=Math.max(0,...h.map(({diameter:f})=>f));for(let{name:f,nodes:p}of c??[]){let x=4*(r[u]+p[0]),g=be(s.shown.subarray(x,x+3));if(!g.every(Number.isFinite))continue;let[m,v,M]=g,w=(c??[]).length>Gx?10:15,R=n.joint;if(t.push({x:m,y:v,z:M,kind:"knot",colour:R,size:1.9*d,pixels:w}),l?.joint!==f||l.variant!==u)continue;let T=26*o.pose.distance/o.focal,y=lt(g,o.top,T);this.labels.push({id:`joint ${f}`,from:g,at:y,text:f,kind:"given"})}})}addForces(t){let{session:e,theme:n,nodes:s,camera:r}=this.viewport,{forces:o}=e.layout.variants[0];if(!this.reactions||!o.length)return;let a=o.map(({force:h})=>Math.hypot(...h)),l=zc(this.strongest,e.layout,r),c=new Set([...a.keys()].sort((h,u)=>a[u]-a[h]).slice(0,Gx));for(let[h,{index:u,force:d}]of o.entries()){if(!(a[h]>0))continue;let f=be(s.shown.subarray(4*u,4*u+3)),p=Hc(f,be(d),l,r);t.push({from:f,to:p,colour:n.load,pixels:2.6,head:!0});let[x,g]=[`given ${h}`,ce(a[h],"N")];c.has(h)&&this.labels.push({id:x,from:f,at:p,text:g,kind:"given"})}}addContacts(){let{session:t,theme:e,nodes:n,camera:s}=this.viewport,r=bf(t.frame.parts[0],n.shown),o=Mf(r);if(!Number.isFinite(o))return;let a=t.status?.playing?.98*this.firmest:0;this.firmest=Math.max(o,a);let l=wf*s.pose.distance/s.focal;this.contacts&&(this.touches=Sf(r,this.firmest,l,e.contact))}addGrabs(t,e){let{session:n,theme:s,nodes:r,starts:o,shifts:a}=this.viewport,l=[...this.held];n.frame.parts.forEach((h,u)=>{for(let d=0;d<h.grabs.length;d+=8){let f=h.grabs[d];if(!(f>=0))continue;let p=4*(o[u]+f),x=be(r.shown.subarray(p,p+3)),g=l.find(({hit:U})=>U.variant===u&&U.node===f),m=g?g.place:lt(h.grabs.subarray(d+1,d+4),a[u]),[v,M,w]=m;g||(e.push({from:x,to:m,colour:s.grab,pixels:2,head:!1}),t.push({x:v,y:M,z:w,kind:"ring",colour:s.grab,size:0,pixels:16}));let[R,T,y]=h.grabs.subarray(d+4,d+7);if(u>0)continue;let A=xE(Math.hypot(R,T,y),h.grabs[d+7]);this.labels.push({id:`grab ${d}`,from:x,at:m,text:A,kind:"grab"})}})}addHand(t,e){let{theme:n}=this.viewport,s=this.chosen&&mr(this.viewport,this.chosen),r=[...this.held];for(let{hit:c,place:h}of r){let u=mr(this.viewport,c);if(!u)continue;e.push({from:u,to:h,colour:n.grab,pixels:2,head:!1});let d=c.kind==="anchor"?this.fastest(c):"",f=`lead ${c.variant} ${c.node}`;d&&this.labels.push({id:f,from:u,at:h,text:d,kind:"grab"})}for(let c of[this.ringPlace(),s,...r.map(({place:h})=>h)]){if(!c)continue;let[h,u,d]=c;t.push({x:h,y:u,z:d,kind:"ring",colour:n.hover,size:0,pixels:24})}let o=this.line?.hit??this.tying,a=o&&mr(this.viewport,o),l=this.line?.to??this.ringPlace()??s;if(a){let[c,h,u]=a;t.push({x:c,y:h,z:u,kind:"ring",colour:n.joint,size:0,pixels:24}),l&&e.push({from:a,to:l,colour:n.joint,pixels:2,head:!1})}this.addKick(e)}fastest({variant:t,anchor:e}){let{layout:n,frame:s,hello:r}=this.viewport.session,o=r?.limits.anchor_speed,a=n?.variants[t].anchors.findIndex(({name:c})=>c===e)??-1;return!o||!s||a<0?"":Math.hypot(...s.parts[t].anchors.subarray(10*a+3,10*a+6))>.995*o?`${ce(o,"m/s")} (no faster)`:""}addKick(t){let{theme:e}=this.viewport;if(!this.kick)return;let{from:n,to:s,text:r}=this.kick;t.push({from:n,to:s,colour:e.grab,pixels:3,head:!0}),this.labels.push({id:"kick",from:n,at:s,text:r,kind:"kick"})}ringPlace(){let{hover:t,viewport:e}=this;return t===null||Array.isArray(t)?t:mr(e,t)}};var Wx=1.3,$x=.6,vE=.25,yE=/^turn\d+$/,_E=.9999,qc=class{constructor(t){this.viewport=t,this.all=[],this.starts=[],this.level=[],this.time=NaN,this.floor=null,this.key="",this.version=0,t.session.on("obstacles",()=>{t.session.layout&&this.take(t.session.layout,t.shifts),t.dirty=!0})}take(t,e){let n=JSON.stringify([t.obstacles??[],e,t.up]);if(n===this.key)return;this.key=n;let s=Xm((t.obstacles??[]).slice(0,Ed),e),{up:r}=this.viewport.camera,o=s.filter(({kind:l,axis:c,motion:h})=>l==="plane"&&!h&&Ht(c,r)>_E),a=o.map(({center:l})=>Ht(l,r));this.floor=a.length?Math.max(...a):null,this.starts=s.filter(l=>!o.includes(l)||l.spin||l.turns||l.wheel!==null),this.all=this.starts,this.level=o.filter(l=>!this.starts.includes(l)),this.version++,this.time=NaN,this.advance()}clock(){let{frame:t,layout:e}=this.viewport.session;return(t?.time??0)-(e?.later??0)}advance(){let t=this.clock();if(t===this.time||(this.time=t,!this.starts.some(qm)))return;let e=this.told();this.all=this.starts.map(n=>Ym(n,t,e)),this.version++}named(t){return[...this.all,...this.level].find(e=>e.name===t)??null}base(t){let e=this.named(t);return e?$t($t(e.center,e.middle),this.viewport.shifts[0]??[0,0,0]):null}angleOf(t){return this.turns()[this.all.findIndex(e=>e.name===t)]??0}told(){let{frame:t,layout:e}=this.viewport.session,n=t?.parts[0];return!e||!n?[]:e.scalars.filter(s=>yE.test(s)).map(s=>Be(e,n,s))}turns(){let t=this.clock(),e=this.told();return this.all.map(n=>Rd(n,t,e))}places(t){let{layout:e}=this.viewport.session;if(!e)return[];let{center:n,radius:s}=e.view;return this.all.filter(({reach:r})=>Number.isFinite(r)).flatMap(r=>wE(Tl(r),t)).map(r=>{let o=$t(r,n),a=Li(o);return a>Wx*s?lt(n,Dt(o,Wx*s/a)):r})}lowest(){let{up:t}=this.viewport.camera,e=this.all.filter(({reach:n})=>Number.isFinite(n)).map(n=>Ht(n.center,t)-Cd(n,t));return Math.min(1/0,...e)}};function wE(i,{low:t,high:e}){let n=Math.max(...e.map((l,c)=>l-t[c]));if(!Number.isFinite(n))return i;let s=t.map((l,c)=>Math.min(...i.map(h=>h[c]))),r=t.map((l,c)=>Math.max(...i.map(h=>h[c]))),o=t.map((l,c)=>Math.max(s[c]-e[c],l-r[c]));if(o.some(l=>l>$x*n))return[];let a=o.map(l=>(l>0?$x:vE)*n);return i.map(l=>be(l.map((c,h)=>Math.min(e[h]+a[h],Math.max(t[h]-a[h],c)))))}var bE=1,ME=12,Yc=class{constructor(t,e){this.session=t,this.renderer=e,this.camera=new Tc,this.nodes=new Er(4),this.anchors=new Er(0),this.range=new ua,this.beyond=[!1,!1],this.colouring="tension",this.tensions=[],this.dots=!1,this.apart=!1,this.shifts=[[0,0,0]],this.starts=[0],this.corners=new Uint8Array(0),this.theme=Nf(),this.marks=new Xc(this),this.dirty=!0,this.drawn=0,this.spacing=1,this.floor=new Nc(this),this.gaps=new Wc(this),this.solids=new qc(this),this.flight=null,this.uncovering=!1,this.follower=new Oc(this),this.framing=new Gc(this),this.following=!0,this.ownVersion=-1,this.axis=-1,this.lying=!1,this.past=!1,this.lookPending=!0,this.layoutNumber=-1,this.up=[0,0,1],this.sceneKey="",this.lastTime=-1/0,this.lastPush=0,this.cameraVersion=-1,this.card=()=>null,this.beforeDraw=[],this.afterDraw=[],t.on("layout",s=>this.takeLayout(s)),t.on("frame",s=>this.takeFrame(s)),t.on("broken",()=>{this.range.fresh=!0,this.past=t.broken!==null}),e.setTheme(this.theme),e.canvas.addEventListener("webglcontextrestored",()=>this.setTheme());let n=s=>{requestAnimationFrame(n),this.tick(s)};requestAnimationFrame(n)}takeLayout(t){if(this.dirty=!0,t.layout===this.layoutNumber){this.follow(t),this.solids.take(t,this.shifts);return}this.layoutNumber=t.layout,this.starts=vo(t);let e=ti(t),[n,s]=Tr(e);this.nodes=new Er(4*n*s),this.anchors=new Er(3*t.variants.reduce((o,{anchors:a})=>o+a.length,0)),this.gaps.take(t,-1/0),this.corners=X0(t),this.marks.setLayout(t);let r=`${t.scene.name} ${t.scene.preset} ${t.variants.length>1&&this.apart}`;r===this.sceneKey?this.follow(t):(this.up=t.up,this.camera.setUp(t.up),this.sceneKey=r,this.lookPending=!0,this.range.fresh=!0),this.shift(t)}follow({up:t,gravity:e}){t.every((s,r)=>Math.abs(s-this.up[r])<1e-6)||e.every(s=>s===0)||(this.up=t,this.camera.setUp(t),this.lookPending=!0)}shift(t){let e=this.lookPending?this.camera.first:this.camera.right;this.shifts=q0(t,this.apart,e,2.1*t.view.radius),this.solids.take(t,this.shifts)}setApart(t){this.apart=t;let{layout:e,frame:n}=this.session;e&&(this.shift(e),this.lookPending=!0,n&&this.takeFrame(n,!0))}takeFrame(t,e=!1){let n=this.session.layout,s=performance.now(),r=e||t.time<this.lastTime||!(t.flags&1);t.time<this.lastTime&&this.marks.trails?.clear(),(t.time<this.lastTime||t.time>this.lastTime+bE)&&(this.range.fresh=!0,this.marks.strongest=0),this.lastTime=t.time,this.gaps.take(n,t.time);let o=this.nodes.next(s,r),a=Cx(t,n,this.colouring,this.shifts,o);bx(o,ti(n),n.view),this.past=this.session.broken!==null||(t.flags&2)!==0,(this.session.hello?.mode==="live"||!(t.flags&2)||this.range.unknown)&&(this.tensions=a.tensions,this.range.follow(a.low,a.high,Math.min(.2,(s-this.lastPush)/1e3))),this.beyond=this.range.beyond(a.low,a.high),this.lastPush=s,e||this.marks.take(t),Ix(t,this.shifts,this.anchors.next(s,r)),this.lookPending?this.look(n):this.past||this.follower.take(n,s),this.marks.trails&&this.marks.trails.push(this.nodes.to),this.dirty=!0}showInstead(t,e=0){let{frame:n}=this.session;if(!n)return;if(!t)return this.takeFrame(n,!0);let s=Float32Array.from(t.flat()),r=n.parts.map((o,a)=>a===e&&s.length===o.positions.length?{...o,positions:s}:o);this.takeFrame({...n,parts:r,flags:n.flags|2},!0)}look(t){this.lookPending=!1;let e=Rc(this.nodes.to,ti(t)),n=Mx(e,this.camera.up,t.view.radius);this.lying=Sx(n,this.camera.up,t.gravity),this.axis=this.lying?-1:n,this.floor.put(t,e),this.follower.ropes.clear(),this.setPose(this.framing.first(t)),this.following=!0,this.flight=null}get leastWidth(){let{layout:t}=this.session;return t?ti(t)>4e3?4:t.variants[0].ropes.length>ME?5:8:8}thickness(){let{camera:t,session:e}=this,n=e.layout?.variants.flatMap(r=>r.ropes)??[],s=Math.max(1e-9,...n.map(r=>r.diameter));return Math.max(1,this.leastWidth*t.pose.distance/t.focal/s)}held=()=>!1;landed=()=>{};legendCard=()=>null;bars=()=>[];windowShape=innerWidth/innerHeight;setPose(t){this.camera.set(t),this.ownVersion=this.camera.version}fit(t={}){let{layout:e}=this.session;!e||this.nodes.empty||(this.following=!0,this.follower.ropes.clear(),this.fly(this.framing.clear(e,t)))}uncover(){this.lookPending||!this.framing.obstructed()||(this.fit(),this.uncovering=!0)}fly(t,e){this.ownVersion=this.camera.version,matchMedia("(prefers-reduced-motion: reduce)").matches?this.setPose(t):this.flight=new Ac(this.camera.pose,t,performance.now(),e)}setColouring(t){this.colouring=t,this.range=new ua,this.session.frame&&this.takeFrame(this.session.frame,!0)}setTheme(){this.theme=Nf(),this.renderer.setTheme(this.theme),this.dirty=!0}resize(t,e){let n=this.camera.version===this.ownVersion;this.camera.resize(t,e),n&&(this.ownVersion=this.camera.version),this.renderer.resize(t,e,Math.min(2,devicePixelRatio||1));let s=innerWidth/innerHeight;this.following&&Math.abs(s/this.windowShape-1)>.3&&(this.lookPending=!0),this.windowShape=s,this.following&&this.uncover(),this.past&&this.following&&!this.flight&&this.framing.losesArrow()&&this.fit();let{layout:r,frame:o}=this.session;r&&o&&this.lookPending&&this.look(r),this.renderer.clear(),this.draw(!0)}land(){this.flight=null,this.uncovering||this.landed(),this.uncovering=!1}tick(t){this.floor.advance();let e=this.nodes.advance(performance.now());this.anchors.advance(performance.now()),this.nodes.empty||this.follower.advance(t);let s=this.camera.version!==this.cameraVersion||this.dirty||this.marks.dirty||this.renderer.unfinished;(e||s)&&this.draw(e||this.dirty),this.session.acknowledge()}draw(t){let{layout:e}=this.session;if(!e||this.nodes.empty)return;if(t)for(let s of this.beforeDraw)s();this.dirty=this.marks.dirty=!1,this.cameraVersion=this.camera.version,this.solids.advance();let n=Tx(this.camera,this.floor);this.spacing=n.spacing,this.renderer.draw({camera:this.camera,nodes:this.nodes.shown,moved:t,range:this.range,plain:this.colouring==="plain",dots:this.dots,pixels:this.leastWidth,smooth:!this.past,corners:this.corners,...this.marks.collect(),touches:this.marks.touches,posts:this.marks.posts,trails:this.marks.trails,ground:n,room:e.view,solids:this.solids.all,turns:this.solids.turns()}),this.drawn++;for(let s of this.afterDraw)s()}screenOf(t,e=0){let n=4*(this.starts[e]+t),{shown:s}=this.nodes,[r,o,a]=this.camera.project(s[n],s[n+1],s[n+2]);return{x:r,y:o,depth:a}}};var Xx="(max-width: 700px), (max-height: 500px)",Kc=class{constructor(t,e,n){this.session=e,this.root=t;let s=(c,h)=>z(c,{className:h,id:h});this.barHost=s("header","bar"),this.meterHost=s("section","meter"),this.scene=s("main","scene"),this.panel=s("aside","panel"),this.graphHost=s("section","graphs"),this.footer=s("footer","controls");let r=z("canvas",{id:"view",tabIndex:0,"aria-label":"The ropes"});this.scene.append(r),t.replaceChildren(this.barHost,this.meterHost,this.scene,this.panel,this.graphHost,this.footer),this.graphHost.hidden=!0,this.viewport=new Yc(e,n(r)),this.labels=new cc(this.viewport,this.scene),this.notices=new mc(e,this.scene),this.legend=new fc(this.viewport,this.scene),this.parted=new gc(e,c=>this.notices.say(c)),this.balance=new jl(e),this.legend.card.append(this.parted.host,this.balance.host),this.views=new Sc(this.viewport,this.scene),this.graphs=new Jl(this.viewport,this.graphHost),this.tools=new vc(this.viewport,this.scene,c=>this.follow(c),(c,h)=>this.notices.say(c,h)),this.pointer=new Ll(this.viewport,this.viewport.renderer.canvas,{use:(c,h)=>this.tools.use(c,h),tie:(c,h)=>{this.tools.tieNone(),this.viewport.marks.tying=c,this.tools.tie(h)},menu:(c,h,u)=>this.tools.menu(c,h,u)}),this.tools.pointer=this.pointer;let o=z("div",{className:"unseen",role:"status",id:"voice"});this.scene.append(o),this.walk=new Pl(this.viewport,this.viewport.renderer.canvas,o,(c,h,u)=>this.tools.menu(c,h,u)),this.viewport.legendCard=()=>this.legend.place(),this.viewport.bars=()=>[this.tools.bar,this.views.bar].flatMap(c=>Gs(c,r)??[]),this.viewport.held=()=>this.pointer.down.size>0,this.meter=new pc(e,this.meterHost),this.controls=new oc(e,this.footer,()=>this.graphs.toggle()),this.controls.undoing=()=>this.pointer.leaveOff(),this.tweak=new Mc(e,this.panel),this.broken=new ec(e,this.scene,(...c)=>this.viewport.showInstead(...c)),this.tour=new yc(e,this.scene),this.scenes=new xc(e,t),this.compare=new nc(this.viewport,t,this.scene,c=>this.compareColours(c));let a=this.viewport.card;this.viewport.card=()=>this.broken.place(this.viewport.renderer.canvas)??a();for(let c of["broken","frame"])e.on(c,()=>this.uncoverBroken());let l=0;e.on("broken",()=>l=0),this.viewport.landed=()=>l++<2&&this.uncoverBroken(),this.help=new ac(t),this.keep=new lc(this.viewport,t,this.notices),this.bar=new Ql(this.barHost,{scenes:()=>this.scenes.open(),tour:()=>this.tour.start(),compare:()=>this.compare.open(),keep:c=>this.keep.open(c),help:()=>this.help.open(),theme:()=>this.toggleTheme(),panel:()=>this.togglePanel()}),this.keys=new Ml(e,this.viewport.camera,this.shortcuts()),this.watchHand(),this.panel.hidden=matchMedia(Xx).matches,new ResizeObserver(()=>this.resize()).observe(this.scene),this.resize(),e.on("hello",()=>this.hello()),e.on("layout",({scene:c})=>this.bar.show(c.name)),e.on("status",({address:c})=>this.writeAddress(c)),this.asked=!1,addEventListener("hashchange",()=>this.openAddress())}uncoverBroken(){let{viewport:t,session:e}=this;e.broken&&t.following&&!t.flight&&!t.held()&&t.uncover()}shortcuts(){return{" ":()=>this.controls.toggle(),".":()=>this.controls.doStep(),r:()=>this.controls.doReset(),undo:()=>this.controls.doUndo(),f:()=>this.viewport.fit(),g:()=>this.graphs.toggle(),p:()=>this.togglePanel(),t:()=>this.toggleTheme(),h:()=>this.help.open(),"?":()=>this.help.open(),escape:()=>this.tools.tieNone()}}watchHand(){let{source:t}=this.session,e=t.send.bind(t);t.send=n=>{e(n),["drag","move","grab","obstacle"].includes(n.type)&&this.tour.handMoved()}}hello(){let{session:t}=this,e=t.hello,n=this.viewport.renderer.name==="webgl"?"WebGL":"Canvas 2D";this.help.version.textContent=`Ropewalk ${e.ropewalk}, drawn with ${n}.`,this.root.dataset.mode=e.mode,this.bar.compare.hidden=!t.can("compare"),this.bar.tour.hidden=!t.can("set"),this.bar.choose.disabled=!t.can("scene");let s=t.can("set");s||(this.panel.hidden=!0),this.bar.panel.hidden=!s,!this.asked&&location.hash.slice(1)!==e.address&&this.openAddress(),this.asked=!0,this.resize()}openAddress(){let{session:t}=this,e=location.hash.slice(1);e&&e!==t.status?.address&&t.can("scene")&&t.tell({type:"scene",address:e})}writeAddress(t){!this.session.source.base||!t||location.hash.slice(1)===t||history.replaceState(null,"",`#${t}`)}follow(t){this.viewport.marks.toggleTrail(t),this.graphs.rebuild(),!this.graphs.open&&this.viewport.marks.followed.size===1&&!matchMedia(Xx).matches&&this.graphs.toggle(!0)}compareColours(t){this.legend.select.value=t?"plain":"tension",this.legend.choose()}togglePanel(){this.bar.panel.hidden||(this.panel.hidden=!this.panel.hidden,this.resize())}toggleTheme(){Cc(document.documentElement.dataset.theme==="dark"?"light":"dark",!0),this.viewport.setTheme(),this.graphs.rebuild()}resize(){this.root.classList.toggle("with-panel",!this.panel.hidden);let{clientWidth:t,clientHeight:e}=this.scene;t&&e&&this.viewport.resize(t,e)}};function qx(i){let{session:t,viewport:e}=i;return{app:i,session:t,viewport:e,get frames(){return t.frames},get drawn(){return e.drawn},get frame(){return t.frame?.number??-1},get time(){return t.frame?.time??NaN},get renderer(){return e.renderer.name},get state(){return t.connection!=="open"?t.connection:t.frame?t.broken?"broken":t.status?.playing?"playing":"paused":"waiting"},screenOf(n,s=0){let r=e.renderer.canvas.getBoundingClientRect(),{x:o,y:a}=e.screenOf(n,s);return{x:o+r.left,y:a+r.top}},nodeAt(n,s=0){let r=t.frame?.parts[s];return r?[...r.positions.subarray(3*n,3*n+3)]:null}}}var Zc=class{constructor(){this.marks=[]}restart(){this.marks=[]}note(t,e){let{marks:n}=this;for(n.push([t,e]);n.length>2&&n[1][0]<=t-500;)n.shift()}get reached(){let[t,e]=[this.marks[0],this.marks[this.marks.length-1]];return!t||e[0]-t[0]<100?null:1e3*(e[1]-t[1])/(e[0]-t[0])}};var SE=250,EE=.1,TE=60,Yx=["play","pause","step","speed","seek","reset"],Rr=class{constructor(t,e,n){this.hello={...t,can:Yx},this.run=e,this.frames=n,this.base=n.base,this.time=0,this.speed=1,this.playing=e.playing,this.pace=new Zc,this.number=0,this.shown=-1,this.leapt=!1,this.part=-1,this.last=0,this.lastStatus=0,this.first=[];let s=0;for(let r of e.parts)this.first.push(s),s+=r.frames;this.times=new Float64Array(0),this.layouts=[],this.events=null,this.jumped=()=>{}}async open(t){this.events=t;try{this.times=await this.frames.times(),this.layouts[0]=await this.frames.layout(0)}catch(n){t.state("damaged",`This page cannot be shown: ${Ca(n)}.`);return}t.state("open",""),t.message(this.hello),this.tellLayout(0),t.message({type:"parameters",parameters:[]}),t.message({type:"presets",presets:[]}),this.tellStatus(),this.last=performance.now();let e=n=>{this.tick(n),requestAnimationFrame(e)};requestAnimationFrame(e)}send(t){let e=this.obey(t);e||(this.show(this.index),this.tellStatus());let{id:n,type:s}=t;if(n===void 0)return;let r=this.number+(this.index===this.shown?0:1),o={id:n,command:s};queueMicrotask(()=>this.events?.message(e?{type:"error",...o,text:e}:{type:"done",...o,step:this.index,frame:r}))}obey({type:t,time:e,value:n,count:s=1}){let{duration:r}=this.run;switch(t){case"play":return this.time>=r&&this.moveTo(0),this.playing=!0,this.last=performance.now(),this.pace.restart(),"";case"pause":return this.playing=!1,"";case"step":return this.playing=!1,this.time=this.times[Math.min(this.index+s,this.times.length-1)],"";case"speed":return this.speed=n,this.pace.restart(),"";case"seek":return e>=0&&e<=r*(1+1e-9)?(this.moveTo(Math.min(e,r)),""):`time: ${e} - must be from 0 to ${r} s`;case"reset":return this.moveTo(0),""}return`${t}: cannot be done in a replay; there is ${Yx.join(", ")}`}used(){}moveTo(t){this.time=t,this.leapt=!0,this.pace.restart()}get index(){return this.indexAt(this.time)}indexAt(t){let[e,n]=[0,this.times.length];for(;n-e>1;){let s=e+n>>1;this.times[s]<=t+this.frames.within?e=s:n=s}return e}get sound(){return this.times.length-1-this.run.single}get every(){let t=this.sound/Math.max(this.times[this.sound],1e-9);return Math.max(1,Math.floor(this.speed*t*1.001/TE))}tick(t){let e=Math.min(.25,Math.max(0,(t-this.last)/1e3));if(this.last=t,!this.playing){this.show(this.index);return}let n=this.leapt?this.time:this.later(e*this.speed);this.show(this.next(n))&&(this.time=n),this.pace.note(t,this.time),this.playing=this.time<this.run.duration,(!this.playing||t-this.lastStatus>SE)&&this.tellStatus()}later(t){let{duration:e,single:n}=this.run,{time:s}=this,r=this.times[this.sound];if(!n||s+t<r)return Math.min(s+t,e);if(s<r)return r;let o=Math.min(1,(e-r)/(n*EE));return Math.min(s+t*o,e)}next(t){let e=this.indexAt(t),{shown:n,every:s,sound:r}=this;return this.leapt||n<0||e<n||e>=r?e:n+s*Math.floor((e-n)/s)}show(t){if(!this.events||t===this.shown)return this.leapt=!1,!0;let e=this.shown<t&&this.shown>=0&&!this.leapt,n=this.partOf(t),s=this.frames.take(t,e?this.shown:t-1,t>=this.sound?1:this.every,this.playing);if(!s||!this.layoutThere(n))return!1;n!==this.part&&this.tellLayout(n);let r=this.leapt&&Math.abs(t-this.shown)>2;return[this.shown,this.leapt]=[t,!1],this.number++,this.stamp(s),r&&this.jumped(),this.events.frame(s),!0}stamp(t){let e=new DataView(t);e.setUint32(8,this.number,!0),this.playing&&e.setUint32(12,e.getUint32(12,!0)|1,!0),e.setFloat32(32,this.playing?this.pace.reached??0:0,!0),e.setFloat32(36,this.speed,!0)}partOf(t){let e=this.first.length-1;for(;this.first[e]>t;)e--;return e}layoutThere(t){return this.layouts[t]?!0:(this.frames.layout(t).then(e=>this.layouts[t]=e,()=>{}),!1)}tellLayout(t){this.part=t,this.events?.message(this.layouts[t])}async read(t,e,n,s){let r=Math.min(e,Math.ceil((this.times.length-t)/n));if(r<=0)return[];let o=await this.frames.read(t,r,n,s),a=[];for(let[l,c]of o.entries()){let h=this.partOf(t+l*n);this.layouts[h]??=await this.frames.layout(h),a.push({buffer:c,layout:this.layouts[h]})}return a}tellStatus(){this.lastStatus=performance.now();let{method:t,dt:e}=this.run.parts[Math.max(this.part,0)];this.events?.message({type:"status",playing:this.playing,speed:this.speed,realtime:this.playing?this.pace.reached:0,slow:!1,text:"",time:this.time,step:this.index,dt:e,steps_per_frame:1,method:t,broken:!1,clients:1,address:"",duration:this.run.duration})}},Ca=i=>i instanceof Error?i.message:String(i);var AE=900,RE=600,CE=60,IE=24e6,PE=2e6,LE=120,Jc=class{constructor(t,e){this.app=t,this.read=e,this.timer=0,this.stop=new AbortController,this.known="",this.until=-1,this.coarse=[],t.graphs.wanted=()=>this.want()}want(){clearTimeout(this.timer),this.stop.abort(),this.timer=window.setTimeout(()=>this.fill(),LE)}async fill(){this.stop.abort(),this.stop=new AbortController;let{signal:t}=this.stop;try{await this.fetch(t)}catch(e){if(t.aborted||e instanceof TypeError)return;let n=`The graphs cannot tell of the time before: ${Ca(e)}.`;this.app.session.take({type:"error",text:n})}}async fetch(t){let{graphs:e,session:n,viewport:s}=this.app,{layout:r,frame:o}=n;if(!e.open||!r||!o||o.steps<1)return;let[a,l]=[o.steps,o.time],c=Math.min(e.window,l),h=Math.min(a,Math.ceil(c*a/Math.max(l,1e-9))),u=`${r.layout} ${[...s.marks.followed]}`;(u!==this.known||a>this.until)&&(this.coarse=await this.samples(0,a,RE,r,t),[this.known,this.until]=[u,a]);let d=await this.samples(a-h,h,AE,r,t);if(n.layout!==r||!n.frame||n.frame.time<l)return;let f=d[0]?.time??l,{history:p}=e;p.clear();for(let{time:x,values:g}of this.coarse)x<f&&p.add(x,g);for(let{time:x,values:g}of d)p.add(x,g);e.take(n.frame),e.bounds()}async samples(t,e,n,s,r){let o=Math.max(CE,Math.floor(IE/s.bytes)),a=Math.max(1,Math.ceil(e/Math.min(n,o))),l=Math.max(1,Math.floor(PE/s.bytes)),c=[...this.app.viewport.marks.followed],h=t+e,u=[];for(let d=t;d<h;d+=l*a){let f=Math.ceil((h-d)/a),p=await this.read(d,Math.min(l,f),a,r);if(r.aborted)throw r.reason;for(let{frame:x,layout:g}of p)x.flags&2||u.push({time:x.time,values:NE(s,g,x,c)})}return u}};function NE(i,t,e,n){if(t.layout===i.layout)return ba(i,e,n);let s=Ma(t),r=Ma(i).filter(([,a],l)=>a!==s[l][1]),o=n.filter(a=>a<t.variants[0].nodes);return ba(t,e,o).filter(([a])=>!r.some(([l])=>l.test(a)))}function kf(i,t){let e=new Jc(i,async(n,s,r,o)=>(await t.read(n,s,r,o)).map(({buffer:l,layout:c})=>({frame:ur(l,c),layout:c})));t.jumped=()=>{i.viewport.marks.trails?.clear(),e.want()}}var Bf=[-.3,.4],Ia=new Float64Array(3),Pa=new Float64Array(3);function Jx(i,t,e,n,s,r){let o=t.first+t.count-1,a=4*r;for(let l=t.first;l<o;l++){let c=4*l,h=zf(i,c,c+4),u=l>t.first&&!n[l],d=l+1<o&&!n[l+1];u&&Kx(i,c,c,h,Ia),d&&Kx(i,c+4,c,h,Pa);for(let f=0;f<3;f++){let p=i[c+4+f]-i[c+f];u||(Ia[f]=d?1.5*p-.5*Pa[f]:p),d||(Pa[f]=u?1.5*p-.5*Ia[f]:p)}Zx(Ia,1.6*h),Zx(Pa,1.6*h);for(let f=0;f<e;f++,a+=4){let p=f/e,[x,g]=[p*p,p*p*p],[m,v,M]=[3*x-2*g,p-2*x+g,g-x];for(let w=0;w<3;w++){let R=i[c+w];s[a+w]=R+m*(i[c+4+w]-R)+v*Ia[w]+M*Pa[w]}s[a+3]=i[c+3]+p*(i[c+7]-i[c+3])}}for(let l=0;l<4;l++)s[a+l]=i[4*o+l]}function Kx(i,t,e,n,s){let r=zf(i,t-4,t),o=zf(i,t,t+4),a=Math.sqrt(n);if(!(r>0&&o>0)){for(let f=0;f<3;f++)s[f]=i[e+4+f]-i[e+f];return}let[l,c]=[Math.sqrt(r),Math.sqrt(o)],h=0;for(let f=0;f<3;f++)h+=(i[t+f]-i[t-4+f])*(i[t+4+f]-i[t+f])/(r*o);let u=Math.min(1,Math.max(0,(h-Bf[0])/(Bf[1]-Bf[0]))),d=u*u*(3-2*u);for(let f=0;f<3;f++){let[p,x,g]=[i[t-4+f],i[t+f],i[t+4+f]],m=(x-p)/l-(g-p)/(l+c)+(g-x)/c,v=i[e+4+f]-i[e+f];s[f]=v+d*(m*a-v)}}function Zx(i,t){let e=Math.hypot(i[0],i[1],i[2]);if(e>t)for(let n=0;n<3;n++)i[n]*=t/e}function zf(i,t,e){return Math.hypot(i[e]-i[t],i[e+1]-i[t+1],i[e+2]-i[t+2])}function jx(i,t,e,n){let s=4*t,[r,o,a]=[1,0,0],[l,c,h]=[n[s],n[s+1],n[s+2]],u=!1;for(let d=0;d<e;d++,s+=4){if(d>0&&d+1===e){n[s]=l,n[s+1]=c,n[s+2]=h;break}let f=i[s+4]-i[s],p=i[s+5]-i[s+1],x=i[s+6]-i[s+2],g=Math.sqrt(f*f+p*p+x*x);if(g>0){let[m,v,M]=[f/g,p/g,x/g];if(u){let T=r*m+o*v+a*M;if(T>-.999){let y=(l*m+c*v+h*M)/(1+T);l-=y*(r+m),c-=y*(o+v),h-=y*(a+M)}}[r,o,a]=[m,v,M];let w=l*r+c*o+h*a;[l,c,h]=[l-w*r,c-w*o,h-w*a];let R=Math.sqrt(l*l+c*c+h*h);R>.001||([l,c,h]=Math.abs(a)<.9?[-o,r,0]:[0,-a,o],R=Math.sqrt(l*l+c*c+h*h)),l/=R,c/=R,h/=R,u=!0}n[s]=l,n[s+1]=c,n[s+2]=h}}var DE=7,Hf=1.5,OE=8,FE=16,Mo=class{constructor(t,e){this.budget=t,this.laid=e,this.steps=0,this.every=1,this.nodes={nodes:0,ropes:[]},this.shape={nodes:0,ropes:[]},this.points=new Float32Array(4),this.normals=new Float32Array(4)}setShape(t){this.nodes=t,this.steps=0}update(t){let[e,n]=this.wanted(t),s=e!==this.steps||n!==this.every;return s&&this.build(e,n),!s&&!t.moved?!1:(this.nodes.ropes.forEach((r,o)=>{let{first:a,count:l}=this.shape.ropes[o];n>1?UE(t.nodes,r.first,r.count,n,this.points,a):e>1?Jx(t.nodes,r,e,t.corners,this.points,a):this.points.set(t.nodes.subarray(4*r.first,4*(r.first+r.count)),4*a),this.framed&&jx(this.points,a,l,this.normals)}),s)}get framed(){return this.shape.nodes<=this.laid}wanted({camera:t,smooth:e,dots:n}){let{ropes:s,nodes:r}=this.nodes;if(!e||!r)return[1,1];let a=s.reduce((u,{spacing:d})=>Math.max(u,d),0)*t.focal/t.pose.distance;if(!n&&(a<Hf||this.every>1&&a<1.3*Hf)){let u=Math.min(FE,2**Math.round(Math.log2(2*Hf/a)));return[1,this.every>1&&u<4*this.every&&this.every<4*u?this.every:Math.max(2,u)]}let l=Math.max(1,Math.min(OE,Math.floor(this.budget/r))),c=Math.max(1,Math.min(l,Math.ceil(a/DE)));return[this.steps>=c&&this.steps<=Math.max(2,2*c)&&this.steps<=l?this.steps:c,1]}build(t,e){let n=this.shape.ropes.map(({first:l})=>this.normals.slice(4*l,4*l+3));[this.steps,this.every]=[t,e];let s=0,r=this.nodes.ropes.map(l=>{let c=s,h=Math.max(0,l.count-1),u=e>1?Math.ceil(h/e):h*t,d=l.count>0?u+1:0;return s+=d,{...l,first:c,count:d,spacing:l.spacing*h/Math.max(1,u)}});this.shape={nodes:s,ropes:r};let[o,a]=Tr(s);this.points=new Float32Array(4*o*a),this.normals=new Float32Array(this.framed?4*o*a:4),this.framed&&r.forEach(({first:l,count:c,spacing:h},u)=>{n.length===r.length&&this.normals.set(n[u],4*l);for(let d=0;d<c;d++)this.normals[4*(l+d)+3]=d*h})}};function UE(i,t,e,n,s,r){let o=4*r;for(let l=0;l<e-1;l+=n,o+=4){let c=Math.min(l+n,e-1),h=4*(t+l),u=i[h+3];for(let d=l+1;d<c;d++)u=Math.max(u,i[4*(t+d)+3]);s[o]=i[h],s[o+1]=i[h+1],s[o+2]=i[h+2],s[o+3]=u}let a=4*(t+e-1);for(let l=0;l<4;l++)s[o+l]=i[a+l]}var jc=14,Qx=8;function tv(i,t,e){let{width:n,height:s,focal:r}=t,o=s/2-r*Math.tan(Math.min(1.5,t.pose.elevation)),a=c=>Math.min(1,Math.max(0,c/s)),l=i.createLinearGradient(0,0,0,s);l.addColorStop(0,Ue(o>0?e.background:e.ground)),l.addColorStop(a(o),Ue(o>0?e.horizon:e.ground)),l.addColorStop(a(o+.35*s),Ue(e.ground)),i.fillStyle=l,i.fillRect(0,0,n,s)}function ev(i,t,e,n){i.lineWidth=1;let s=[[],[],[]];for(let[r,o]of[[t.first,t.second],[t.second,t.first]])for(let a=-jc;a<=jc;a++){let l=lt(e.center,r,a*e.spacing);for(let c=0;c<Qx;c++){let[h,u]=[c,c+1].map(x=>(2*x/Qx-1)*jc),d=Math.hypot(a,(h+u)/2)/jc;if(d>.95)continue;let f=t.project(...lt(l,o,h*e.spacing)),p=t.project(...lt(l,o,u*e.spacing));f[2]<=.02*t.pose.distance||p[2]<=.02*t.pose.distance||s[d<.45?0:d<.7?1:2].push(f[0],f[1],p[0],p[1])}}s.forEach((r,o)=>{i.strokeStyle=Ue(n.grid,[.8,.5,.2][o]),i.beginPath();for(let a=0;a<r.length;a+=4)i.moveTo(r[a],r[a+1]),i.lineTo(r[a+2],r[a+3]);i.stroke()})}function nv(i,t,e){let[n,s,r]=t.project(e.x,e.y,e.z);if(r<=0)return;let o=.5*Math.max(e.pixels,e.size*t.focal/r),a=e.colour.map(l=>.72*l);if(i.beginPath(),e.kind==="ring"){i.arc(n,s,o-1.2,0,2*Math.PI),i.lineWidth=2.4,i.strokeStyle=Ue(e.colour),i.stroke();return}if(e.kind==="eye"){i.arc(n,s,.7*o,0,2*Math.PI);for(let[l,c]of[[.65,a],[.4,e.colour]])i.lineWidth=l*o,i.strokeStyle=Ue(c),i.stroke();return}if(i.arc(n,s,o,0,2*Math.PI),i.fillStyle=Ue(e.colour),i.fill(),i.lineWidth=1.5,i.strokeStyle=Ue(a),e.kind==="knot"){let l=.6*o;i.moveTo(n-l,s+l),i.lineTo(n+l,s-l),i.moveTo(n-l,s-l),i.lineTo(n+l,s+l)}i.stroke()}function Qc(i,t,e){let[n,s,r]=t.project(e.from[0],e.from[1],e.from[2]),[o,a,l]=t.project(e.to[0],e.to[1],e.to[2]);if(r<=0||l<=0)return;let c=Math.hypot(o-n,a-s);if(c<1)return;let[h,u]=[(o-n)/c,(a-s)/c],d=e.head?Math.min(.5*c,5.5*e.pixels):0;if(i.lineCap="butt",i.lineWidth=e.pixels,i.strokeStyle=i.fillStyle=Ue(e.colour),i.beginPath(),i.moveTo(n,s),i.lineTo(o-d*h,a-d*u),i.stroke(),i.lineCap="round",!d)return;let f=2.2*e.pixels;i.beginPath(),i.moveTo(o,a),i.lineTo(o-d*h-f*u,a-d*u+f*h),i.lineTo(o-d*h+f*u,a-d*u-f*h),i.fill()}var kE=2e4;function iv(i,t,e,n){let{surface:s,center:r}=e;if(!s)return;let[o,a,l]=zs(e),c=([d,f,p])=>lt(lt(Dt(o,d),a,f),l,p),h=s.places.length/9,u=[];for(let d=0;d<h;d+=Math.ceil(h/kE)){let f=[0,1,2].map(M=>lt(r,c(dr(s.places,3*d+M)))),p=[0,1,2].map(M=>c(dr(s.normals,3*d+M))),x=Dt(lt(lt(p[0],p[1]),p[2]),1/3);if(Ht(x,$t(t.eye,f[0]))<=0)continue;let g=f.map(M=>t.project(...M));if(g.some(([,,M])=>M<.02*t.pose.distance))continue;let m=Math.max(Ht(x,t.light)+.2,0)/1.2,v=.6+.2*Ht(x,t.up)+.35*m*m;u.push({flat:g,light:v,depth:g.reduce((M,w)=>M+w[2],0)})}u.sort((d,f)=>f.depth-d.depth),i.lineWidth=.7;for(let{flat:d,light:f}of u){let p=Ue(n.body.map(x=>Math.min(1,f*x)));i.fillStyle=i.strokeStyle=p,i.beginPath();for(let[x,g]of d)i.lineTo(x,g);i.closePath(),i.fill(),i.stroke()}}var Na=36,sv=6,La=12,Vf=8,BE=20;function ov(i,t,e){let{camera:n,solids:s,turns:r,room:o}=t,a=c=>n.project(...c.center)[2],l=s.map((c,h)=>({solid:c,turn:r[h],depth:a(c)}));l.sort((c,h)=>h.depth-c.depth);for(let{solid:c,turn:h}of l)c.kind==="plane"?GE(i,n,c,o.radius,e):c.kind==="mesh"?iv(i,n,c,e):c.kind==="torus"?VE(i,n,c,e):c.kind==="half-pipe"?WE(i,n,c,o,e):HE(i,n,c,o.radius,e),El(c)&&$E(i,n,c,h,o.radius,e)}var So=(i,t)=>Ue(i.body.map(e=>Math.min(1,t*e)));function Da(i,t,e){let n=Tn(pn(t,Math.abs(t[2])<.9?[0,0,1]:[1,0,0])),s=pn(t,n);return Array.from({length:Na},(r,o)=>{let a=2*Math.PI*o/Na;return lt(lt(i,n,e*Math.cos(a)),s,e*Math.sin(a))})}function Gf({center:i,axis:t,size:e},n){let s=Math.min(e[1],BE*n);return[lt(i,t,-s),lt(i,t,s)]}function zE(i,t,e){let{kind:n,center:s,axis:r,size:o}=t,a=zs(t),l=(h,u)=>Da(h,Tn($t(i.eye,h)),u);if(n==="sphere")return l(s,o[0]);let c=Gf(t,e);return n==="cylinder"?c.flatMap(h=>Da(h,r,o[0])):n==="capsule"?c.flatMap(h=>l(h,o[0])):Array.from({length:8},(h,u)=>l(a.reduce((d,f,p)=>lt(d,f,u>>p&1?o[p]:-o[p]),s),o[3])).flat()}function HE(i,t,e,n,s){let r=qE(Eo(t,zE(t,e,n)));if(r.length<3)return;let[o,a]=[Math.min,Math.max].map(c=>c(...r.map(([,h])=>h))),l=i.createLinearGradient(0,o,0,a);if(l.addColorStop(0,So(s,1.15)),l.addColorStop(1,So(s,.68)),i.fillStyle=l,th(i,r),e.kind==="cylinder")for(let[c,h]of Gf(e,n).entries()){let u=Dt(e.axis,c?1:-1),f=$t(t.eye,h).reduce((p,x,g)=>p+x*u[g],0)>0?Eo(t,Da(h,e.axis,e.size[0])):[];i.fillStyle=So(s,.92),f.length===Na&&th(i,f)}}function VE(i,t,{center:e,axis:n,size:s},r){let o=Eo(t,Da(e,n,s[0]));if(o.length<Na)return;let a=2*s[1]*t.focal/t.project(...e)[2];for(let[l,c]of[[1,.75],[.55,1.05]]){i.lineWidth=l*a,i.strokeStyle=So(r,c),i.beginPath();for(let[h,u]of o)i.lineTo(h,u);i.closePath(),i.stroke()}}function GE(i,t,{center:e,axis:n},s,r){let o=Eo(t,Da(e,n,2.2*s));o.length<Na||(i.fillStyle=Ue(r.body,.55),th(i,o))}function WE(i,t,{center:e,axis:n,size:s},r,o){let a=s.slice(1),l=pn(a,n),c=lt(e,n,Ht($t(r.center,e),n)),h=u=>{let d=Math.PI*Math.min(Math.max(u,0),La)/La,f=lt(c,l,s[0]*Math.cos(d)),p=u<0||u>La?Sl*s[0]:-s[0]*Math.sin(d);return lt(f,a,p)};for(let u=0;u<La+2;u++){let[d,f]=[h(u-1),h(u)],p=Dt(lt(d,f),.5),x=Tn(pn(n,$t(f,d)));if(!(Ht(x,$t(t.eye,p))*Ht(x,$t(lt(c,a,.1*s[0]),p))<=0)){i.fillStyle=So(o,.75+.35*Math.sin(Math.PI*(u+.5)/(La+2)));for(let m=-Vf;m<Vf;m++){let[v,M]=[m,m+1].map(T=>2.2*T*r.radius/Vf),w=[lt(d,n,v),lt(d,n,M),lt(f,n,M),lt(f,n,v)],R=Eo(t,w);R.length===4&&th(i,R)}}}}function $E(i,t,e,n,s,r){let{kind:o,center:a,axis:l,zero:c,size:h}=e,u=pn(l,c);i.strokeStyle=So(r,.5);for(let d=0;d<sv;d++){let f=n+2*Math.PI*d/sv,p=lt(Dt(c,Math.cos(f)),u,Math.sin(f)),x=XE(o,p,e,s).map(({way:g,normal:m})=>({seen:Eo(t,g),facing:$t(t.eye,lt(a,p,h[0])).reduce((v,M,w)=>v+M*m[w],0),whole:g.length}));i.lineWidth=d?2:4;for(let{seen:g,facing:m,whole:v}of x)if(!(m<=0||g.length<v)){i.beginPath();for(let[M,w]of g)i.lineTo(M,w);i.stroke()}}}function XE(i,t,e,n){let{center:s,axis:r,size:o}=e;if(i==="plane")return[{way:[s,lt(s,t,2*n)],normal:r}];if(i==="sphere")return[{way:rv(e,t,s,o[0]),normal:t}];if(i==="torus")return[{way:rv(e,t,lt(s,t,o[0]),o[1]),normal:t}];let a=Gf(e,n),l=a.map(h=>lt(h,t,o[0])),c=a.map((h,u)=>({way:[h,l[u]],normal:Dt(r,u?1:-1)}));return[{way:l,normal:t},...i==="cylinder"?c:[]]}function rv({axis:i},t,e,n){return Array.from({length:13},(s,r)=>{let o=Math.PI*(r/12-.5),a=lt(e,i,n*Math.sin(o));return lt(a,t,n*Math.cos(o))})}function Eo(i,t){return t.map(e=>i.project(...e)).filter(([,,e])=>e>.02*i.pose.distance).map(([e,n])=>[e,n])}function th(i,t){i.beginPath();for(let[e,n]of t)i.lineTo(e,n);i.fill()}function qE(i){let t=[...i].sort((n,s)=>n[0]-s[0]||n[1]-s[1]),e=n=>{let s=[];for(let r of n){for(;s.length>1;){let[o,a]=s.slice(-2);if((a[0]-o[0])*(r[1]-o[1])-(a[1]-o[1])*(r[0]-o[0])>0)break;s.pop()}s.push(r)}return s.slice(0,-1)};return[...e(t),...e(t.reverse())]}var Oa=32,YE=1200,Wf=6,Fa=class{constructor(t){let e=t.getContext("2d",{alpha:!1});if(!e)throw new Error("no canvas to draw on");this.name="canvas",this.canvas=t,this.context=e,this.colours=[],this.line=new Mo(YE,0),this.shape={nodes:0,ropes:[]},this.seen=new Float32Array(0),this.batch=new Uint8Array(0),this.ratio=1,this.rough=this.unfinished=!1,this.theme=null}setShape(t){this.line.setShape(t)}setTheme(t){this.theme=t;let e=io(t.dark);this.colours=Array.from({length:Oa},(n,s)=>Ue(e[Math.round(s/(Oa-1)*(e.length-1))]))}resize(t,e,n){this.canvas.width=Math.round(t*n),this.canvas.height=Math.round(e*n),this.ratio=n}clear(){let{context:t,canvas:e,theme:n}=this;t.setTransform(1,0,0,1,0,0),t.fillStyle=n?Ue(n.background):"#888888",t.fillRect(0,0,e.width,e.height)}follow(t){this.line.update(t)&&(this.shape=this.line.shape,this.seen=new Float32Array(3*this.shape.nodes),this.batch=new Uint8Array(this.shape.nodes))}draw(t){let{context:e,theme:n}=this;if(n){this.follow(t),this.clear(),e.setTransform(this.ratio,0,0,this.ratio,0,0),e.lineJoin="round",e.lineCap="round",tv(e,t.camera,n),ev(e,t.camera,t.ground,n),this.shadows(t,n);for(let s of t.posts)Qc(e,t.camera,s);ov(e,t,n),this.project(t,null),t.solids.length&&this.hide(t),t.trails&&!t.trails.empty&&this.trails(t),this.ropes(t),t.dots&&this.dots(n);for(let s of t.markers)nv(e,t.camera,s);for(let s of t.touches){let{camera:r,solids:o}=t;o.some(l=>fr(l,r.eye,s.to,0))||Qc(e,r,s)}for(let s of t.arrows)Qc(e,t.camera,s)}}shadows(t,e){let{context:n}=this;this.project(t,t.ground.height),n.strokeStyle=Ue(e.shadow,e.dark?.5:.16);for(let s of this.shape.ropes)n.lineWidth=this.width(s,t)*1.2,n.beginPath(),this.path(s),n.stroke()}project(t,e){let{seen:n}=this,{camera:s}=t,{points:r}=this.line,o=s.view,[a,l,c]=s.up,h=lt(s.light,s.up,-Ht(s.light,s.up)),[u,d,f]=lt(s.up,h,.75/Ht(s.light,s.up)),[p,x,g]=[s.width/2,s.height/2,s.focal];for(let m=0;m<this.shape.nodes;m++){let[v,M,w]=[r[4*m],r[4*m+1],r[4*m+2]];if(e!==null){let y=v*a+M*l+w*c-e;v-=y*u,M-=y*d,w-=y*f}let R=-(o[2]*v+o[6]*M+o[10]*w+o[14]),T=g/Math.max(R,1e-9);n[3*m]=p+(o[0]*v+o[4]*M+o[8]*w+o[12])*T,n[3*m+1]=x-(o[1]*v+o[5]*M+o[9]*w+o[13])*T,n[3*m+2]=r[4*m+3]>1e30?-1:R}}hide({camera:t,solids:e,pixels:n}){let{seen:s}=this,{points:r}=this.line;for(let o of this.shape.ropes)for(let a=o.first;a<o.first+o.count;a++){let l=r.subarray(4*a,4*a+3),c=Math.max(o.radius,.5*n*s[3*a+2]/t.focal);e.some(h=>fr(h,t.eye,l,c))&&(s[3*a+2]*=-1)}}width(t,e){let n=this.seen[3*(t.first+(t.count>>1))+2],s=Math.max(1e-9,Math.abs(n));return Math.max(e.pixels,2*t.radius*e.camera.focal/s)}path(t){let{context:e,seen:n}=this,s=!1;for(let r=t.first;r<t.first+t.count;r++){let o=n[3*r+2]<=0;s&&!o?e.lineTo(n[3*r],n[3*r+1]):e.moveTo(n[3*r],n[3*r+1]),s=!o}}ropes(t){let{context:e}=this,n=this.theme;for(let s of this.shape.ropes){let r=this.width(s,t);if(t.plain){e.lineWidth=r,e.strokeStyle=Ue(s.colour),e.beginPath(),this.path(s),e.stroke();continue}this.coloured(s,t,r),r>6&&(e.lineWidth=r*.25,e.strokeStyle=n.dark?"rgba(255, 255, 255, 0.18)":"rgba(255, 255, 255, 0.3)",e.beginPath(),this.path(s),e.stroke())}}coloured(t,e,n){let{context:s,seen:r,batch:o}=this,{points:a}=this.line,{low:l,high:c}=e.range,h=Oa/Math.max(c-l,1e-30),u=t.first+t.count-1;for(let d=t.first;d<u;d++){let f=.5*(a[4*d+3]+a[4*d+7]);o[d]=Math.min(Oa-1,Math.max(0,Math.floor((f-l)*h)))}s.lineWidth=n;for(let d=0;d<Oa;d++){let f=!1,p=!1;for(let x=t.first;x<u;x++){if(!(o[x]===d)||!(r[3*x+2]>0&&r[3*x+5]>0)){f=!1;continue}p||s.beginPath(),f||s.moveTo(r[3*x],r[3*x+1]),s.lineTo(r[3*x+3],r[3*x+4]),f=p=!0}p&&(s.strokeStyle=this.colours[d],s.stroke())}}dots(t){let{context:e,seen:n}=this;e.fillStyle=Ue(t.node),e.beginPath();for(let{first:s,count:r}of this.shape.ropes)for(let o=s;o<s+r;o+=this.line.steps)n[3*o+2]<=0||(e.moveTo(n[3*o]+2.2,n[3*o+1]),e.arc(n[3*o],n[3*o+1],2.2,0,2*Math.PI));e.fill()}trails(t){let e=t.trails,{context:n}=this;n.lineWidth=2.5;let s=360/Wf;e.nodes.forEach((r,o)=>{for(let a=0;a<Wf;a++){n.strokeStyle=Ue(e.colours[o],.7*((a+1)/Wf)**2),n.beginPath();for(let l=a*s;l<=Math.min((a+1)*s,359);l++){let c=4*(o*360+(e.head+l)%360),h=e.points,[u,d,f]=t.camera.project(h[c],h[c+1],h[c+2]);f>0&&n.lineTo(u,d)}n.stroke()}})}dispose(){}};var Iv=0,yp=1,Pv=2;var nl=1,Lv=2,Yo=3,rr=0,ei=1,Ri=2,Rs=0,Ko=1,_p=2,wp=3,bp=4,eu=5;var kr=100,Nv=101,Dv=102,nu=103,Ov=104,Fv=200,il=201,Uv=202,kv=203,Mp=204,Sp=205,Bv=206,zv=207,Hv=208,Vv=209,Gv=210,Wv=211,$v=212,Xv=213,qv=214,Eh=0,zo=1,Th=2,Ho=3,Ah=4,Rh=5,Ch=6,Ih=7,Ep=0,Yv=1,Kv=2,cs=0,Tp=1,Ap=2,Rp=3,Cp=4,Ip=5,Pp=6,Lp=7;var Np=300,Br=301,Zo=302,iu=303,su=304,Ph=1e3,ss=1001,Lh=1002,rn=1003,Zv=1004;var sl=1005;var kn=1006,ru=1007;var Cs=1008;var xi=1009,Dp=1010,Op=1011,Jo=1012,ou=1013,vi=1014,Hn=1015,Wi=1016,au=1017,lu=1018,zr=1020,Fp=35902,Up=35899,kp=1021,Bp=1022,Vn=1023,Ts=1026,Is=1027,zp=1028,cu=1029,or=1030,hu=1031;var jo=1033,rl=33776,ol=33777,al=33778,ll=33779,uu=35840,du=35841,fu=35842,pu=35843,mu=36196,gu=37492,xu=37496,vu=37488,yu=37489,cl=37490,_u=37491,wu=37808,bu=37809,Mu=37810,Su=37811,Eu=37812,Tu=37813,Au=37814,Ru=37815,Cu=37816,Iu=37817,Pu=37818,Lu=37819,Nu=37820,Du=37821,Ou=36492,Fu=36494,Uu=36495,ku=36283,Bu=36284,hl=36285,zu=36286;var Va=2300,Nh=2301,Mh=2302,dp=2303,fp=2400,pp=2401,mp=2402;var Jv=3200;var Hp=0,jv=1,Ps="",fi="srgb",js="srgb-linear",Ga="linear",Pe="srgb";var Sh=7680;var Qv=519,ty=512,ey=513,ny=514,Vp=515,iy=516,sy=517,Gp=518,Wp=519,ry=35044,ul=35048;var dl="300 es",Ti=2e3,Wa=2001;function KE(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function ZE(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function $a(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function oy(){let i=$a("canvas");return i.style.display="block",i}var av={},Vo=null;function $p(...i){let t="THREE."+i.shift();Vo?Vo("log",t,...i):console.log(t,...i)}function ay(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function jt(...i){i=ay(i);let t="THREE."+i.shift();if(Vo)Vo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function ne(...i){i=ay(i);let t="THREE."+i.shift();if(Vo)Vo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function Ha(...i){let t=i.join(" ");t in av||(av[t]=!0,jt(...i))}function ly(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var cy={[Eh]:Eh,[Th]:Ch,[Ah]:Ah,[Ho]:Rh,[zo]:zo,[Ch]:Th,[Ih]:Ih,[Rh]:Ho},rs=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Wn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var $f=Math.PI/180,Dh=180/Math.PI;function fl(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Wn[i&255]+Wn[i>>8&255]+Wn[i>>16&255]+Wn[i>>24&255]+"-"+Wn[t&255]+Wn[t>>8&255]+"-"+Wn[t>>16&15|64]+Wn[t>>24&255]+"-"+Wn[e&63|128]+Wn[e>>8&255]+"-"+Wn[e>>16&255]+Wn[e>>24&255]+Wn[n&255]+Wn[n>>8&255]+Wn[n>>16&255]+Wn[n>>24&255]).toLowerCase()}function Me(i,t,e){return Math.max(t,Math.min(e,i))}function JE(i,t){return(i%t+t)%t}function Xf(i,t,e){return(1-e)*i+e*t}function hy(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Xp(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function jE(i,t){if(t.constructor===Float32Array)return i;let e=Xp(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function QE(i,t){if(t.constructor===Float32Array)return i;let e=Xp(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var xe=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Me(this.x,t.x,e.x),this.y=Me(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Me(this.x,t,e),this.y=Me(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Me(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Me(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},os=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||l!==d||c!==f||h!==p){let g=l*d+c*f+h*p+u*x;g<0&&(d=-d,f=-f,p=-p,x=-x,g=-g);let m=1-a;if(g<.9995){let v=Math.acos(g),M=Math.sin(v);m=Math.sin(m*v)/M,a=Math.sin(a*v)/M,l=l*m+d*a,c=c*m+f*a,h=h*m+p*a,u=u*m+x*a}else{l=l*m+d*a,c=c*m+f*a,h=h*m+p*a,u=u*m+x*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*u+l*f-c*d,t[e+1]=l*p+h*d+c*u-a*f,t[e+2]=c*p+h*f+a*d-l*u,t[e+3]=h*p-a*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Me(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},J=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(lv.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(lv.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Me(this.x,t.x,e.x),this.y=Me(this.y,t.y,e.y),this.z=Me(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Me(this.x,t,e),this.y=Me(this.y,t,e),this.z=Me(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Me(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return qf.copy(this).projectOnVector(t),this.sub(qf)}reflect(t){return this.sub(qf.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Me(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},qf=new J,lv=new os,ie=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],x=s[0],g=s[3],m=s[6],v=s[1],M=s[4],w=s[7],R=s[2],T=s[5],y=s[8];return r[0]=o*x+a*v+l*R,r[3]=o*g+a*M+l*T,r[6]=o*m+a*w+l*y,r[1]=c*x+h*v+u*R,r[4]=c*g+h*M+u*T,r[7]=c*m+h*w+u*y,r[2]=d*x+f*v+p*R,r[5]=d*g+f*M+p*T,r[8]=d*m+f*w+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=e*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=u*x,t[1]=(s*c-h*n)*x,t[2]=(a*n-s*o)*x,t[3]=d*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Ha("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Yf.makeScale(t,e)),this}rotate(t){return Ha("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Yf.makeRotation(-t)),this}translate(t,e){return Ha("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Yf.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Yf=new ie,cv=new ie().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),hv=new ie().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function tT(){let i={enabled:!0,workingColorSpace:js,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pe&&(s.r=Es(s.r),s.g=Es(s.g),s.b=Es(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pe&&(s.r=Bo(s.r),s.g=Bo(s.g),s.b=Bo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ps?Ga:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[js]:{primaries:t,whitePoint:n,transfer:Ga,toXYZ:cv,fromXYZ:hv,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:fi},outputColorSpaceConfig:{drawingBufferColorSpace:fi}},[fi]:{primaries:t,whitePoint:n,transfer:Pe,toXYZ:cv,fromXYZ:hv,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:fi}}}),i}var _e=tT();function Es(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Bo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var To,Oh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{To===void 0&&(To=$a("canvas")),To.width=t.width,To.height=t.height;let s=To.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=To}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=$a("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Es(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Es(e[n]/255)*255):e[n]=Es(e[n]);return{data:e,width:t.width,height:t.height}}else return jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},eT=0,Go=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:eT++}),this.uuid=fl(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Kf(s[o].image)):r.push(Kf(s[o]))}else r=Kf(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Kf(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Oh.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(jt("Texture: Unable to serialize Texture."),{})}var nT=0,Zf=new J,ii=class i extends rs{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=ss,s=ss,r=kn,o=Cs,a=Vn,l=xi,c=i.DEFAULT_ANISOTROPY,h=Ps){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:nT++}),this.uuid=fl(),this.name="",this.source=new Go(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new xe(0,0),this.repeat=new xe(1,1),this.center=new xe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ie,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Zf).x}get height(){return this.source.getSize(Zf).y}get depth(){return this.source.getSize(Zf).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Np)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ph:t.x=t.x-Math.floor(t.x);break;case ss:t.x=t.x<0?0:1;break;case Lh:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ph:t.y=t.y-Math.floor(t.y);break;case ss:t.y=t.y<0?0:1;break;case Lh:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ii.DEFAULT_IMAGE=null;ii.DEFAULT_MAPPING=Np;ii.DEFAULT_ANISOTROPY=1;var We=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],x=l[2],g=l[6],m=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(p-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let M=(c+1)/2,w=(f+1)/2,R=(m+1)/2,T=(h+d)/4,y=(u+x)/4,A=(p+g)/4;return M>w&&M>R?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=T/n,r=y/n):w>R?w<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(w),n=T/s,r=A/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=y/r,s=A/r),this.set(n,s,r,e),this}let v=Math.sqrt((g-p)*(g-p)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(v)<.001&&(v=1),this.x=(g-p)/v,this.y=(u-x)/v,this.z=(d-h)/v,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Me(this.x,t.x,e.x),this.y=Me(this.y,t.y,e.y),this.z=Me(this.z,t.z,e.z),this.w=Me(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Me(this.x,t,e),this.y=Me(this.y,t,e),this.z=Me(this.z,t,e),this.w=Me(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Me(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Fh=class extends rs{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:kn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new We(0,0,t,e),this.scissorTest=!1,this.viewport=new We(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ii({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:kn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Go(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},zn=class extends Fh{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},Xa=class extends ii{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=rn,this.minFilter=rn,this.wrapR=ss,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Uh=class extends ii{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=rn,this.minFilter=rn,this.wrapR=ss,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Ge=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,g)}set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,g){let m=this.elements;return m[0]=t,m[4]=e,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=p,m[11]=x,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Ao.setFromMatrixColumn(t,0).length(),r=1/Ao.setFromMatrixColumn(t,1).length(),o=1/Ao.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+p*c,e[5]=d-x*c,e[9]=-a*l,e[2]=x-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d+x*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=x+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d-x*a,e[4]=-o*u,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=x-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=p*c-f,e[8]=d*c+x,e[1]=l*u,e[5]=x*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=x-d*u,e[8]=p*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*u+p,e[10]=d-x*u}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+x,e[5]=o*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=a*h,e[10]=x*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(iT,t,sT)}lookAt(t,e,n){let s=this.elements;return ui.subVectors(t,e),ui.lengthSq()===0&&(ui.z=1),ui.normalize(),Xs.crossVectors(n,ui),Xs.lengthSq()===0&&(Math.abs(n.z)===1?ui.x+=1e-4:ui.z+=1e-4,ui.normalize(),Xs.crossVectors(n,ui)),Xs.normalize(),eh.crossVectors(ui,Xs),s[0]=Xs.x,s[4]=eh.x,s[8]=ui.x,s[1]=Xs.y,s[5]=eh.y,s[9]=ui.y,s[2]=Xs.z,s[6]=eh.z,s[10]=ui.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],x=n[6],g=n[10],m=n[14],v=n[3],M=n[7],w=n[11],R=n[15],T=s[0],y=s[4],A=s[8],U=s[12],N=s[1],P=s[5],G=s[9],W=s[13],D=s[2],V=s[6],$=s[10],k=s[14],ot=s[3],K=s[7],Q=s[11],st=s[15];return r[0]=o*T+a*N+l*D+c*ot,r[4]=o*y+a*P+l*V+c*K,r[8]=o*A+a*G+l*$+c*Q,r[12]=o*U+a*W+l*k+c*st,r[1]=h*T+u*N+d*D+f*ot,r[5]=h*y+u*P+d*V+f*K,r[9]=h*A+u*G+d*$+f*Q,r[13]=h*U+u*W+d*k+f*st,r[2]=p*T+x*N+g*D+m*ot,r[6]=p*y+x*P+g*V+m*K,r[10]=p*A+x*G+g*$+m*Q,r[14]=p*U+x*W+g*k+m*st,r[3]=v*T+M*N+w*D+R*ot,r[7]=v*y+M*P+w*V+R*K,r[11]=v*A+M*G+w*$+R*Q,r[15]=v*U+M*W+w*k+R*st,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],x=t[7],g=t[11],m=t[15],v=l*f-c*d,M=a*f-c*u,w=a*d-l*u,R=o*f-c*h,T=o*d-l*h,y=o*u-a*h;return e*(x*v-g*M+m*w)-n*(p*v-g*R+m*T)+s*(p*M-x*R+m*y)-r*(p*w-x*T+g*y)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],x=t[13],g=t[14],m=t[15],v=e*a-n*o,M=e*l-s*o,w=e*c-r*o,R=n*l-s*a,T=n*c-r*a,y=s*c-r*l,A=h*x-u*p,U=h*g-d*p,N=h*m-f*p,P=u*g-d*x,G=u*m-f*x,W=d*m-f*g,D=v*W-M*G+w*P+R*N-T*U+y*A;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/D;return t[0]=(a*W-l*G+c*P)*V,t[1]=(s*G-n*W-r*P)*V,t[2]=(x*y-g*T+m*R)*V,t[3]=(d*T-u*y-f*R)*V,t[4]=(l*N-o*W-c*U)*V,t[5]=(e*W-s*N+r*U)*V,t[6]=(g*w-p*y-m*M)*V,t[7]=(h*y-d*w+f*M)*V,t[8]=(o*G-a*N+c*A)*V,t[9]=(n*N-e*G-r*A)*V,t[10]=(p*T-x*w+m*v)*V,t[11]=(u*w-h*T-f*v)*V,t[12]=(a*U-o*P-l*A)*V,t[13]=(e*P-n*U+s*A)*V,t[14]=(x*M-p*R-g*v)*V,t[15]=(h*R-u*M+d*v)*V,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,x=o*h,g=o*u,m=a*u,v=l*c,M=l*h,w=l*u,R=n.x,T=n.y,y=n.z;return s[0]=(1-(x+m))*R,s[1]=(f+w)*R,s[2]=(p-M)*R,s[3]=0,s[4]=(f-w)*T,s[5]=(1-(d+m))*T,s[6]=(g+v)*T,s[7]=0,s[8]=(p+M)*y,s[9]=(g-v)*y,s[10]=(1-(d+x))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Ao.set(s[0],s[1],s[2]).length(),a=Ao.set(s[4],s[5],s[6]).length(),l=Ao.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Bi.copy(this);let c=1/o,h=1/a,u=1/l;return Bi.elements[0]*=c,Bi.elements[1]*=c,Bi.elements[2]*=c,Bi.elements[4]*=h,Bi.elements[5]*=h,Bi.elements[6]*=h,Bi.elements[8]*=u,Bi.elements[9]*=u,Bi.elements[10]*=u,e.setFromRotationMatrix(Bi),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=Ti,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===Ti)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Wa)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Ti,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===Ti)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===Wa)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Ao=new J,Bi=new Ge,iT=new J(0,0,0),sT=new J(1,1,1),Xs=new J,eh=new J,ui=new J,uv=new Ge,dv=new os,Qs=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Me(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Me(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Me(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Me(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Me(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Me(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return uv.makeRotationFromQuaternion(t),this.setFromRotationMatrix(uv,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return dv.setFromEuler(this),this.setFromQuaternion(dv,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Qs.DEFAULT_ORDER="XYZ";var qa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},rT=0,fv=new J,Ro=new os,_s=new Ge,nh=new J,Ua=new J,oT=new J,aT=new os,pv=new J(1,0,0),mv=new J(0,1,0),gv=new J(0,0,1),xv={type:"added"},lT={type:"removed"},Co={type:"childadded",child:null},Jf={type:"childremoved",child:null},mi=class i extends rs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:rT++}),this.uuid=fl(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new J,e=new Qs,n=new os,s=new J(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ge},normalMatrix:{value:new ie}}),this.matrix=new Ge,this.matrixWorld=new Ge,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new qa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Ro.setFromAxisAngle(t,e),this.quaternion.multiply(Ro),this}rotateOnWorldAxis(t,e){return Ro.setFromAxisAngle(t,e),this.quaternion.premultiply(Ro),this}rotateX(t){return this.rotateOnAxis(pv,t)}rotateY(t){return this.rotateOnAxis(mv,t)}rotateZ(t){return this.rotateOnAxis(gv,t)}translateOnAxis(t,e){return fv.copy(t).applyQuaternion(this.quaternion),this.position.add(fv.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(pv,t)}translateY(t){return this.translateOnAxis(mv,t)}translateZ(t){return this.translateOnAxis(gv,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(_s.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?nh.copy(t):nh.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ua.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?_s.lookAt(Ua,nh,this.up):_s.lookAt(nh,Ua,this.up),this.quaternion.setFromRotationMatrix(_s),s&&(_s.extractRotation(s.matrixWorld),Ro.setFromRotationMatrix(_s),this.quaternion.premultiply(Ro.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ne("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(xv),Co.child=t,this.dispatchEvent(Co),Co.child=null):ne("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(lT),Jf.child=t,this.dispatchEvent(Jf),Jf.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),_s.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),_s.multiply(t.parent.matrixWorld)),t.applyMatrix4(_s),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(xv),Co.child=t,this.dispatchEvent(Co),Co.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ua,t,oT),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ua,aT,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};mi.DEFAULT_UP=new J(0,1,0);mi.DEFAULT_MATRIX_AUTO_UPDATE=!0;mi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Nr=class extends mi{constructor(){super(),this.isGroup=!0,this.type="Group"}},cT={type:"move"},Wo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Nr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Nr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new J,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new J),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Nr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new J,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new J,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let g=e.getJointPose(x,n),m=this._getHandJoint(c,x);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(cT)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Nr;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},uy={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},qs={h:0,s:0,l:0},ih={h:0,s:0,l:0};function jf(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var we=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=fi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,_e.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=_e.workingColorSpace){return this.r=t,this.g=e,this.b=n,_e.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=_e.workingColorSpace){if(t=JE(t,1),e=Me(e,0,1),n=Me(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=jf(o,r,t+1/3),this.g=jf(o,r,t),this.b=jf(o,r,t-1/3)}return _e.colorSpaceToWorking(this,s),this}setStyle(t,e=fi){function n(r){r!==void 0&&parseFloat(r)<1&&jt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:jt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=fi){let n=uy[t.toLowerCase()];return n!==void 0?this.setHex(n,e):jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Es(t.r),this.g=Es(t.g),this.b=Es(t.b),this}copyLinearToSRGB(t){return this.r=Bo(t.r),this.g=Bo(t.g),this.b=Bo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=fi){return _e.workingToColorSpace($n.copy(this),t),Math.round(Me($n.r*255,0,255))*65536+Math.round(Me($n.g*255,0,255))*256+Math.round(Me($n.b*255,0,255))}getHexString(t=fi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=_e.workingColorSpace){_e.workingToColorSpace($n.copy(this),e);let n=$n.r,s=$n.g,r=$n.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=_e.workingColorSpace){return _e.workingToColorSpace($n.copy(this),e),t.r=$n.r,t.g=$n.g,t.b=$n.b,t}getStyle(t=fi){_e.workingToColorSpace($n.copy(this),t);let e=$n.r,n=$n.g,s=$n.b;return t!==fi?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(qs),this.setHSL(qs.h+t,qs.s+e,qs.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(qs),t.getHSL(ih);let n=Xf(qs.h,ih.h,e),s=Xf(qs.s,ih.s,e),r=Xf(qs.l,ih.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},$n=new we;we.NAMES=uy;var as=class extends mi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Qs,this.environmentIntensity=1,this.environmentRotation=new Qs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},zi=new J,ws=new J,Qf=new J,bs=new J,Io=new J,Po=new J,vv=new J,tp=new J,ep=new J,np=new J,ip=new We,sp=new We,rp=new We,Js=class i{constructor(t=new J,e=new J,n=new J){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),zi.subVectors(t,e),s.cross(zi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){zi.subVectors(s,e),ws.subVectors(n,e),Qf.subVectors(t,e);let o=zi.dot(zi),a=zi.dot(ws),l=zi.dot(Qf),c=ws.dot(ws),h=ws.dot(Qf),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,bs)===null?!1:bs.x>=0&&bs.y>=0&&bs.x+bs.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,bs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,bs.x),l.addScaledVector(o,bs.y),l.addScaledVector(a,bs.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return ip.setScalar(0),sp.setScalar(0),rp.setScalar(0),ip.fromBufferAttribute(t,e),sp.fromBufferAttribute(t,n),rp.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(ip,r.x),o.addScaledVector(sp,r.y),o.addScaledVector(rp,r.z),o}static isFrontFacing(t,e,n,s){return zi.subVectors(n,e),ws.subVectors(t,e),zi.cross(ws).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return zi.subVectors(this.c,this.b),ws.subVectors(this.a,this.b),zi.cross(ws).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Io.subVectors(s,n),Po.subVectors(r,n),tp.subVectors(t,n);let l=Io.dot(tp),c=Po.dot(tp);if(l<=0&&c<=0)return e.copy(n);ep.subVectors(t,s);let h=Io.dot(ep),u=Po.dot(ep);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(Io,o);np.subVectors(t,r);let f=Io.dot(np),p=Po.dot(np);if(p>=0&&f<=p)return e.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(n).addScaledVector(Po,a);let g=h*p-f*u;if(g<=0&&u-h>=0&&f-p>=0)return vv.subVectors(r,s),a=(u-h)/(u-h+(f-p)),e.copy(s).addScaledVector(vv,a);let m=1/(g+x+d);return o=x*m,a=d*m,e.copy(n).addScaledVector(Io,o).addScaledVector(Po,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},tr=class{constructor(t=new J(1/0,1/0,1/0),e=new J(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Hi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Hi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Hi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Hi):Hi.fromBufferAttribute(r,o),Hi.applyMatrix4(t.matrixWorld),this.expandByPoint(Hi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),sh.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),sh.copy(n.boundingBox)),sh.applyMatrix4(t.matrixWorld),this.union(sh)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Hi),Hi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ka),rh.subVectors(this.max,ka),Lo.subVectors(t.a,ka),No.subVectors(t.b,ka),Do.subVectors(t.c,ka),Ys.subVectors(No,Lo),Ks.subVectors(Do,No),Cr.subVectors(Lo,Do);let e=[0,-Ys.z,Ys.y,0,-Ks.z,Ks.y,0,-Cr.z,Cr.y,Ys.z,0,-Ys.x,Ks.z,0,-Ks.x,Cr.z,0,-Cr.x,-Ys.y,Ys.x,0,-Ks.y,Ks.x,0,-Cr.y,Cr.x,0];return!op(e,Lo,No,Do,rh)||(e=[1,0,0,0,1,0,0,0,1],!op(e,Lo,No,Do,rh))?!1:(oh.crossVectors(Ys,Ks),e=[oh.x,oh.y,oh.z],op(e,Lo,No,Do,rh))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Hi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Hi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ms[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ms[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ms[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ms[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ms[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ms[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ms[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ms[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ms),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Ms=[new J,new J,new J,new J,new J,new J,new J,new J],Hi=new J,sh=new tr,Lo=new J,No=new J,Do=new J,Ys=new J,Ks=new J,Cr=new J,ka=new J,rh=new J,oh=new J,Ir=new J;function op(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Ir.fromArray(i,r);let a=s.x*Math.abs(Ir.x)+s.y*Math.abs(Ir.y)+s.z*Math.abs(Ir.z),l=t.dot(Ir),c=e.dot(Ir),h=n.dot(Ir);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Mn=new J,ah=new xe,hT=0,tn=class extends rs{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:hT++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=ry,this.updateRanges=[],this.gpuType=Hn,this.version=0,this._normalizationScale=t!==void 0?Xp(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)ah.fromBufferAttribute(this,e),ah.applyMatrix3(t),this.setXY(e,ah.x,ah.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Mn.fromBufferAttribute(this,e),Mn.applyMatrix3(t),this.setXYZ(e,Mn.x,Mn.y,Mn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Mn.fromBufferAttribute(this,e),Mn.applyMatrix4(t),this.setXYZ(e,Mn.x,Mn.y,Mn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Mn.fromBufferAttribute(this,e),Mn.applyNormalMatrix(t),this.setXYZ(e,Mn.x,Mn.y,Mn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Mn.fromBufferAttribute(this,e),Mn.transformDirection(t),this.setXYZ(e,Mn.x,Mn.y,Mn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):jE(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):QE(t,this.array)}};var Ya=class extends tn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Ka=class extends tn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Ai=class extends tn{constructor(t,e,n){super(new Float32Array(t),e,n)}},uT=new tr,Ba=new J,ap=new J,Dr=class{constructor(t=new J,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):uT.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Ba.subVectors(t,this.center);let e=Ba.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Ba,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(ap.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Ba.copy(t.center).add(ap)),this.expandByPoint(Ba.copy(t.center).sub(ap))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},dT=0,Ei=new Ge,lp=new mi,Oo=new J,di=new tr,za=new tr,Un=new J,en=class i extends rs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:dT++}),this.uuid=fl(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(KE(t)?Ka:Ya)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ie().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ei.makeRotationFromQuaternion(t),this.applyMatrix4(Ei),this}rotateX(t){return Ei.makeRotationX(t),this.applyMatrix4(Ei),this}rotateY(t){return Ei.makeRotationY(t),this.applyMatrix4(Ei),this}rotateZ(t){return Ei.makeRotationZ(t),this.applyMatrix4(Ei),this}translate(t,e,n){return Ei.makeTranslation(t,e,n),this.applyMatrix4(Ei),this}scale(t,e,n){return Ei.makeScale(t,e,n),this.applyMatrix4(Ei),this}lookAt(t){return lp.lookAt(t),lp.updateMatrix(),this.applyMatrix4(lp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Oo).negate(),this.translate(Oo.x,Oo.y,Oo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ai(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new tr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ne("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new J(-1/0,-1/0,-1/0),new J(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];di.setFromBufferAttribute(r),this.morphTargetsRelative?(Un.addVectors(this.boundingBox.min,di.min),this.boundingBox.expandByPoint(Un),Un.addVectors(this.boundingBox.max,di.max),this.boundingBox.expandByPoint(Un)):(this.boundingBox.expandByPoint(di.min),this.boundingBox.expandByPoint(di.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ne('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Dr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ne("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new J,1/0);return}if(t){let n=this.boundingSphere.center;if(di.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];za.setFromBufferAttribute(a),this.morphTargetsRelative?(Un.addVectors(di.min,za.min),di.expandByPoint(Un),Un.addVectors(di.max,za.max),di.expandByPoint(Un)):(di.expandByPoint(za.min),di.expandByPoint(za.max))}di.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Un.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Un));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Un.fromBufferAttribute(a,c),l&&(Oo.fromBufferAttribute(t,c),Un.add(Oo)),s=Math.max(s,n.distanceToSquared(Un))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ne('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ne("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new tn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let U=0;U<n.count;U++)a[U]=new J,l[U]=new J;let h=new J,u=new J,d=new J,f=new xe,p=new xe,x=new xe,g=new J,m=new J;function v(U,N,P){c[U]=c[N]=c[P]=1,h.fromBufferAttribute(n,U),u.fromBufferAttribute(n,N),d.fromBufferAttribute(n,P),f.fromBufferAttribute(r,U),p.fromBufferAttribute(r,N),x.fromBufferAttribute(r,P),u.sub(h),d.sub(h),p.sub(f),x.sub(f);let G=1/(p.x*x.y-x.x*p.y);isFinite(G)&&(g.copy(u).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(G),m.copy(d).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(G),a[U].add(g),a[N].add(g),a[P].add(g),l[U].add(m),l[N].add(m),l[P].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:t.count}]);for(let U=0,N=M.length;U<N;++U){let P=M[U],G=P.start,W=P.count;for(let D=G,V=G+W;D<V;D+=3)v(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let w=new J,R=new J,T=new J,y=new J;function A(U){T.fromBufferAttribute(s,U),y.copy(T);let N=a[U];w.copy(N),w.sub(T.multiplyScalar(T.dot(N))).normalize(),R.crossVectors(y,N);let G=R.dot(l[U])<0?-1:1;o.setXYZW(U,w.x,w.y,w.z,G)}for(let U=0,N=n.count;U<N;++U)c[U]&&A(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new tn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new J,r=new J,o=new J,a=new J,l=new J,c=new J,h=new J,u=new J;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),x=t.getX(d+1),g=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,g),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Un.fromBufferAttribute(t,e),Un.normalize(),t.setXYZ(e,Un.x,Un.y,Un.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let x=0,g=l.length;x<g;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*h;for(let m=0;m<h;m++)d[p++]=c[f++]}return new tn(d,h,u)}if(this.index===null)return jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var cp=new J,fT=new J,pT=new ie,Vi=class{constructor(t=new J(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=cp.subVectors(n,e).cross(fT.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(cp),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||pT.getNormalMatrix(t),s=this.coplanarPoint(cp).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},mT=0,er=class extends rs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:mT++}),this.uuid=fl(),this.name="",this.type="Material",this.blending=Ko,this.side=rr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Mp,this.blendDst=Sp,this.blendEquation=kr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new we(0,0,0),this.blendAlpha=0,this.depthFunc=Ho,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Qv,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Sh,this.stencilZFail=Sh,this.stencilZPass=Sh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){jt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new we().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new Vi().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new xe().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new xe().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Ss=new J,hp=new J,lh=new J,ch=new J,Za=class{constructor(t=new J,e=new J(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ss)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ss.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ss.copy(this.origin).addScaledVector(this.direction,e),Ss.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){hp.copy(t).add(e).multiplyScalar(.5),lh.copy(e).sub(t).normalize(),ch.copy(this.origin).sub(hp);let r=t.distanceTo(e)*.5,o=-this.direction.dot(lh),a=ch.dot(this.direction),l=-ch.dot(lh),c=ch.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(hp).addScaledVector(lh,d),f}intersectSphere(t,e){if(t.radius<0)return null;Ss.subVectors(t.center,this.origin);let n=Ss.dot(this.direction),s=Ss.dot(Ss)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(n=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Ss)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,g=e.z-o.z,m=n.x-o.x,v=n.y-o.y,M=n.z-o.z,w=Math.abs(l),R=Math.abs(c),T=Math.abs(h),y,A,U,N,P,G,W,D,V,$,k,ot;if(w>=R&&w>=T?(U=l,G=u,V=p,ot=m,l>=0?(y=c,A=h,N=d,P=f,W=x,D=g,$=v,k=M):(y=h,A=c,N=f,P=d,W=g,D=x,$=M,k=v)):R>=T?(U=c,G=d,V=x,ot=v,c>=0?(y=h,A=l,N=f,P=u,W=g,D=p,$=M,k=m):(y=l,A=h,N=u,P=f,W=p,D=g,$=m,k=M)):(U=h,G=f,V=g,ot=M,h>=0?(y=l,A=c,N=u,P=d,W=p,D=x,$=m,k=v):(y=c,A=l,N=d,P=u,W=x,D=p,$=v,k=m)),U===0)return null;let K=y/U,Q=A/U,st=1/U,ft=N-K*G,dt=P-Q*G,tt=W-K*V,gt=D-Q*V,yt=$-K*ot,Rt=k-Q*ot,Mt=yt*gt-Rt*tt,qt=ft*Rt-dt*yt,oe=tt*dt-gt*ft;if(s){if(Mt<0||qt<0||oe<0)return null}else if((Mt<0||qt<0||oe<0)&&(Mt>0||qt>0||oe>0))return null;let Wt=Mt+qt+oe;if(Wt===0)return null;let fe=st*(Mt*G+qt*V+oe*ot);return(Wt>0?fe<0:fe>0)?null:this.at(fe/Wt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},kh=class extends er{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new we(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Qs,this.combine=Ep,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},yv=new Ge,Pr=new Za,hh=new Dr,_v=new J,uh=new J,dh=new J,fh=new J,up=new J,ph=new J,wv=new J,mh=new J,nn=class extends mi{constructor(t=new en,e=new kh){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){ph.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(up.fromBufferAttribute(u,t),o?ph.addScaledVector(up,h):ph.addScaledVector(up.sub(e),h))}e.add(ph)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),hh.copy(n.boundingSphere),hh.applyMatrix4(r),Pr.copy(t.ray).recast(t.near),!(hh.containsPoint(Pr.origin)===!1&&(Pr.intersectSphere(hh,_v)===null||Pr.origin.distanceToSquared(_v)>(t.far-t.near)**2))&&(yv.copy(r).invert(),Pr.copy(t.ray).applyMatrix4(yv),!(n.boundingBox!==null&&Pr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Pr)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let g=d[p],m=o[g.materialIndex],v=Math.max(g.start,f.start),M=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let w=v,R=M;w<R;w+=3){let T=a.getX(w),y=a.getX(w+1),A=a.getX(w+2);s=gh(this,m,t,n,c,h,u,T,y,A),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let g=p,m=x;g<m;g+=3){let v=a.getX(g),M=a.getX(g+1),w=a.getX(g+2);s=gh(this,o,t,n,c,h,u,v,M,w),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let g=d[p],m=o[g.materialIndex],v=Math.max(g.start,f.start),M=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let w=v,R=M;w<R;w+=3){let T=w,y=w+1,A=w+2;s=gh(this,m,t,n,c,h,u,T,y,A),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let g=p,m=x;g<m;g+=3){let v=g,M=g+1,w=g+2;s=gh(this,o,t,n,c,h,u,v,M,w),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function gT(i,t,e,n,s,r,o,a){let l;if(t.side===ei?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===rr,a),l===null)return null;mh.copy(a),mh.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(mh);return c<e.near||c>e.far?null:{distance:c,point:mh.clone(),object:i}}function gh(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,uh),i.getVertexPosition(l,dh),i.getVertexPosition(c,fh);let h=gT(i,t,e,n,uh,dh,fh,wv);if(h){let u=new J;Js.getBarycoord(wv,uh,dh,fh,u),s&&(h.uv=Js.getInterpolatedAttribute(s,a,l,c,u,new xe)),r&&(h.uv1=Js.getInterpolatedAttribute(r,a,l,c,u,new xe)),o&&(h.normal=Js.getInterpolatedAttribute(o,a,l,c,u,new J),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new J,materialIndex:0};Js.getNormal(uh,dh,fh,d.normal),h.face=d,h.barycoord=u}return h}var Gi=class extends ii{constructor(t=null,e=1,n=1,s,r,o,a,l,c=rn,h=rn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Lr=new Dr,xT=new xe(.5,.5),xh=new J,Or=class{constructor(t=new Vi,e=new Vi,n=new Vi,s=new Vi,r=new Vi,o=new Vi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ti,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],x=r[9],g=r[10],m=r[11],v=r[12],M=r[13],w=r[14],R=r[15];if(s[0].setComponents(c-o,f-h,m-p,R-v).normalize(),s[1].setComponents(c+o,f+h,m+p,R+v).normalize(),s[2].setComponents(c+a,f+u,m+x,R+M).normalize(),s[3].setComponents(c-a,f-u,m-x,R-M).normalize(),n)s[4].setComponents(l,d,g,w).normalize(),s[5].setComponents(c-l,f-d,m-g,R-w).normalize();else if(s[4].setComponents(c-l,f-d,m-g,R-w).normalize(),e===Ti)s[5].setComponents(c+l,f+d,m+g,R+w).normalize();else if(e===Wa)s[5].setComponents(l,d,g,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Lr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Lr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Lr)}intersectsSprite(t){Lr.center.set(0,0,0);let e=xT.distanceTo(t.center);return Lr.radius=.7071067811865476+e,Lr.applyMatrix4(t.matrixWorld),this.intersectsSphere(Lr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(xh.x=s.normal.x>0?t.max.x:t.min.x,xh.y=s.normal.y>0?t.max.y:t.min.y,xh.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(xh)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},bv=new Ge,Bh=class i{constructor(){this.coordinateSystem=Ti,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];bv.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Or),n[s].setFromProjectionMatrix(bv,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Or),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var zh=class extends er{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new we(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Mv=new Ge,gp=new Za,vh=new Dr,yh=new J,Fr=class extends mi{constructor(t=new en,e=new zh){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),vh.copy(n.boundingSphere),vh.applyMatrix4(s),vh.radius+=r,t.ray.intersectsSphere(vh)===!1)return;Mv.copy(s).invert(),gp.copy(t.ray).applyMatrix4(Mv);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=d,x=f;p<x;p++){let g=c.getX(p);yh.fromBufferAttribute(u,g),Sv(yh,g,l,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let p=d,x=f;p<x;p++)yh.fromBufferAttribute(u,p),Sv(yh,p,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Sv(i,t,e,n,s,r,o){let a=gp.distanceSqToPoint(i);if(a<e){let l=new J;gp.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var Ja=class extends ii{constructor(t=[],e=Br,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var As=class extends ii{constructor(t,e,n=vi,s,r,o,a=rn,l=rn,c,h=Ts,u=1){if(h!==Ts&&h!==Is)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Go(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ja=class extends As{constructor(t,e=vi,n=Br,s,r,o=rn,a=rn,l,c=Ts){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Qa=class extends ii{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},$o=class i extends en{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Ai(c,3)),this.setAttribute("normal",new Ai(h,3)),this.setAttribute("uv",new Ai(u,2));function p(x,g,m,v,M,w,R,T,y,A,U){let N=w/y,P=R/A,G=w/2,W=R/2,D=T/2,V=y+1,$=A+1,k=0,ot=0,K=new J;for(let Q=0;Q<$;Q++){let st=Q*P-W;for(let ft=0;ft<V;ft++){let dt=ft*N-G;K[x]=dt*v,K[g]=st*M,K[m]=D,c.push(K.x,K.y,K.z),K[x]=0,K[g]=0,K[m]=T>0?1:-1,h.push(K.x,K.y,K.z),u.push(ft/y),u.push(1-Q/A),k+=1}}for(let Q=0;Q<A;Q++)for(let st=0;st<y;st++){let ft=d+st+V*Q,dt=d+st+V*(Q+1),tt=d+(st+1)+V*(Q+1),gt=d+(st+1)+V*Q;l.push(ft,dt,gt),l.push(dt,tt,gt),ot+=6}a.addGroup(f,ot,U),f+=ot,d+=k}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var tl=class i extends en{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,f=[],p=[],x=[],g=[];for(let m=0;m<h;m++){let v=m*d-o;for(let M=0;M<c;M++){let w=M*u-r;p.push(w,-v,0),x.push(0,0,1),g.push(M/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let M=v+c*m,w=v+c*(m+1),R=v+1+c*(m+1),T=v+1+c*m;f.push(M,w,T),f.push(w,R,T)}this.setIndex(f),this.setAttribute("position",new Ai(p,3)),this.setAttribute("normal",new Ai(x,3)),this.setAttribute("uv",new Ai(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};function Hr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Ev(s))s.isRenderTargetTexture?(jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Ev(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Xn(i){let t={};for(let e=0;e<i.length;e++){let n=Hr(i[e]);for(let s in n)t[s]=n[s]}return t}function Ev(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function vT(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function qp(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:_e.workingColorSpace}var dy={clone:Hr,merge:Xn},yT=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,_T=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ls=class extends er{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=yT,this.fragmentShader=_T,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Hr(t.uniforms),this.uniformsGroups=vT(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new we().setHex(s.value);break;case"v2":this.uniforms[n].value=new xe().fromArray(s.value);break;case"v3":this.uniforms[n].value=new J().fromArray(s.value);break;case"v4":this.uniforms[n].value=new We().fromArray(s.value);break;case"m3":this.uniforms[n].value=new ie().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ge().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Xo=class extends ls{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Hh=class extends er{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Jv,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Vh=class extends er{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Fo(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function _h(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var nr=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Gh=class extends nr{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:fp,endingEnd:fp}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case pp:r=t,a=2*e-n;break;case mp:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case pp:o=t,l=2*n-e;break;case mp:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-e)/(s-e),x=p*p,g=x*p,m=-d*g+2*d*x-d*p,v=(1+d)*g+(-1.5-2*d)*x+(-.5+d)*p+1,M=(-1-f)*g+(1.5+f)*x+.5*p,w=f*g-f*x;for(let R=0;R!==a;++R)r[R]=m*o[h+R]+v*o[c+R]+M*o[l+R]+w*o[u+R];return r}},Wh=class extends nr{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},$h=class extends nr{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Xh=class extends nr{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-e)/(s-e),x=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*x+o[l+g]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[c+p],g=o[l+p],m=f*d+p*2,v=u[m],M=u[m+1],w=t*d+p*2,R=h[w],T=h[w+1],y=bT(n,e,v,R,s);r[p]=fy(y,x,M,T,g)}return r}};function fy(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function wT(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function bT(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=fy(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=wT(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var gi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Fo(e,this.TimeBufferType),this.values=Fo(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Fo(t.times,Array),values:Fo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),_h(t.settings)&&(n.settings={inTangents:Fo(t.settings.inTangents,Array),outTangents:Fo(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new $h(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Wh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Gh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Xh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Va:e=this.InterpolantFactoryMethodDiscrete;break;case Nh:e=this.InterpolantFactoryMethodLinear;break;case Mh:e=this.InterpolantFactoryMethodSmooth;break;case dp:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return jt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Va;case this.InterpolantFactoryMethodLinear:return Nh;case this.InterpolantFactoryMethodSmooth:return Mh;case this.InterpolantFactoryMethodBezier:return dp}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;_h(this.settings)&&(Tv(this.settings.inTangents,t),Tv(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;_h(this.settings)&&(Av(this.settings.inTangents,t),Av(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ne("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ne("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ne("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ne("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&ZE(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ne("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Mh,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let x=e[u+p];if(x!==e[d+p]||x!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,_h(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Tv(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Av(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}gi.prototype.ValueTypeName="";gi.prototype.TimeBufferType=Float32Array;gi.prototype.ValueBufferType=Float32Array;gi.prototype.DefaultInterpolation=Nh;var ir=class extends gi{constructor(t,e,n){super(t,e,n)}};ir.prototype.ValueTypeName="bool";ir.prototype.ValueBufferType=Array;ir.prototype.DefaultInterpolation=Va;ir.prototype.InterpolantFactoryMethodLinear=void 0;ir.prototype.InterpolantFactoryMethodSmooth=void 0;var qh=class extends gi{constructor(t,e,n,s){super(t,e,n,s)}};qh.prototype.ValueTypeName="color";var Yh=class extends gi{constructor(t,e,n,s){super(t,e,n,s)}};Yh.prototype.ValueTypeName="number";var Kh=class extends nr{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)os.slerpFlat(r,0,o,c-a,o,c,l);return r}},el=class extends gi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Kh(this.times,this.values,this.getValueSize(),t)}};el.prototype.ValueTypeName="quaternion";el.prototype.InterpolantFactoryMethodSmooth=void 0;var sr=class extends gi{constructor(t,e,n){super(t,e,n)}};sr.prototype.ValueTypeName="string";sr.prototype.ValueBufferType=Array;sr.prototype.DefaultInterpolation=Va;sr.prototype.InterpolantFactoryMethodLinear=void 0;sr.prototype.InterpolantFactoryMethodSmooth=void 0;var Zh=class extends gi{constructor(t,e,n,s){super(t,e,n,s)}};Zh.prototype.ValueTypeName="vector";var Jh=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},py=new Jh,jh=class{constructor(t){this.manager=t!==void 0?t:py,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};jh.DEFAULT_MATERIAL_NAME="__DEFAULT";var wh=new J,bh=new os,is=new J,Ur=class extends mi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ge,this.projectionMatrix=new Ge,this.projectionMatrixInverse=new Ge,this.coordinateSystem=Ti,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(wh,bh,is),is.x===1&&is.y===1&&is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(wh,bh,is.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(wh,bh,is),is.x===1&&is.y===1&&is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(wh,bh,is.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Zs=new J,Rv=new xe,Cv=new xe,pi=class extends Ur{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Dh*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan($f*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Dh*2*Math.atan(Math.tan($f*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Zs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Zs.x,Zs.y).multiplyScalar(-t/Zs.z),Zs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Zs.x,Zs.y).multiplyScalar(-t/Zs.z)}getViewSize(t,e){return this.getViewBounds(t,Rv,Cv),e.subVectors(Cv,Rv)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan($f*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Qh=class extends Ur{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var Uo=-90,ko=1,qo=class extends mi{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new pi(Uo,ko,t,e);s.layers=this.layers,this.add(s);let r=new pi(Uo,ko,t,e);r.layers=this.layers,this.add(r);let o=new pi(Uo,ko,t,e);o.layers=this.layers,this.add(o);let a=new pi(Uo,ko,t,e);a.layers=this.layers,this.add(a);let l=new pi(Uo,ko,t,e);l.layers=this.layers,this.add(l);let c=new pi(Uo,ko,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ti)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Wa)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},tu=class extends pi{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Yp="\\[\\]\\.:\\/",MT=new RegExp("["+Yp+"]","g"),Kp="[^"+Yp+"]",ST="[^"+Yp.replace("\\.","")+"]",ET=/((?:WC+[\/:])*)/.source.replace("WC",Kp),TT=/(WCOD+)?/.source.replace("WCOD",ST),AT=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Kp),RT=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Kp),CT=new RegExp("^"+ET+TT+AT+RT+"$"),IT=["material","materials","bones","map"],xp=class{constructor(t,e,n){let s=n||Ze.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Ze=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(MT,"")}static parseTrackName(t){let e=CT.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);IT.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){ne("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ne("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ne("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ne("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ne("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){ne("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){ne("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ne("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ne("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ne("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ze.Composite=xp;Ze.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ze.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ze.prototype.GetterByBindingType=[Ze.prototype._getValue_direct,Ze.prototype._getValue_array,Ze.prototype._getValue_arrayElement,Ze.prototype._getValue_toArray];Ze.prototype.SetterByBindingTypeAndVersioning=[[Ze.prototype._setValue_direct,Ze.prototype._setValue_direct_setNeedsUpdate,Ze.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_array,Ze.prototype._setValue_array_setNeedsUpdate,Ze.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_arrayElement,Ze.prototype._setValue_arrayElement_setNeedsUpdate,Ze.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_fromArray,Ze.prototype._setValue_fromArray_setNeedsUpdate,Ze.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var RO=new Float32Array(1);var vp=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};function Zp(i,t,e,n){let s=PT(n);switch(e){case kp:return i*t;case zp:return i*t/s.components*s.byteLength;case cu:return i*t/s.components*s.byteLength;case or:return i*t*2/s.components*s.byteLength;case hu:return i*t*2/s.components*s.byteLength;case Bp:return i*t*3/s.components*s.byteLength;case Vn:return i*t*4/s.components*s.byteLength;case jo:return i*t*4/s.components*s.byteLength;case rl:case ol:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case al:case ll:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case du:case pu:return Math.max(i,16)*Math.max(t,8)/4;case uu:case fu:return Math.max(i,8)*Math.max(t,8)/2;case mu:case gu:case vu:case yu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case xu:case cl:case _u:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case wu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case bu:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Mu:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Su:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Eu:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Tu:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Au:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Ru:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Cu:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Iu:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Pu:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Lu:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Nu:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Du:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Ou:case Fu:case Uu:return Math.ceil(i/4)*Math.ceil(t/4)*16;case ku:case Bu:return Math.ceil(i/4)*Math.ceil(t/4)*8;case hl:case zu:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function PT(i){switch(i){case xi:case Dp:return{byteLength:1,components:1};case Jo:case Op:case Wi:return{byteLength:2,components:1};case au:case lu:return{byteLength:2,components:4};case vi:case ou:case Hn:return{byteLength:4,components:1};case Fp:case Up:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Fy(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function NT(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],x=u[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let x=u[f];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var DT=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,OT=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,FT=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,UT=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,kT=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,BT=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,zT=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,HT=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,VT=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,GT=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,WT=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,$T=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,XT=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,qT=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,YT=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,KT=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,ZT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,JT=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,jT=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,QT=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,tA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,eA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,nA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,iA=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,sA=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,rA=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,oA=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,aA=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,lA=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,cA="gl_FragColor = linearToOutputTexel( gl_FragColor );",hA=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,uA=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,dA=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,fA=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,pA=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,mA=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,gA=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,xA=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,vA=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,yA=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,_A=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,wA=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,bA=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,MA=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,SA=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,EA=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,TA=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,AA=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,RA=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,CA=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,IA=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,PA=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,LA=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,NA=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,DA=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,OA=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,FA=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,UA=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,kA=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,BA=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,zA=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,HA=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,VA=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,GA=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,WA=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,$A=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,XA=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,qA=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,YA=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,KA=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,ZA=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,JA=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,jA=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,QA=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,tR=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,eR=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,nR=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,iR=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,sR=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,rR=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,oR=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,aR=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,lR=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,cR=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,hR=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,uR=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,dR=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,fR=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,pR=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,mR=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,gR=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,xR=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,vR=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,yR=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,_R=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,wR=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,bR=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,MR=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,SR=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ER=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,TR=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,AR=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,RR=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,CR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,IR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,PR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,LR=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,NR=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,DR=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,OR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,FR=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,UR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,kR=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,BR=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,zR=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,HR=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,VR=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,GR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,WR=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$R=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,XR=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,qR=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,YR=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,KR=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ZR=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,JR=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,jR=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,QR=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,tC=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,eC=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,nC=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,iC=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,sC=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,rC=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,oC=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,aC=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,lC=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cC=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,hC=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,uC=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,dC=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,de={alphahash_fragment:DT,alphahash_pars_fragment:OT,alphamap_fragment:FT,alphamap_pars_fragment:UT,alphatest_fragment:kT,alphatest_pars_fragment:BT,aomap_fragment:zT,aomap_pars_fragment:HT,batching_pars_vertex:VT,batching_vertex:GT,begin_vertex:WT,beginnormal_vertex:$T,bsdfs:XT,iridescence_fragment:qT,bumpmap_pars_fragment:YT,clipping_planes_fragment:KT,clipping_planes_pars_fragment:ZT,clipping_planes_pars_vertex:JT,clipping_planes_vertex:jT,color_fragment:QT,color_pars_fragment:tA,color_pars_vertex:eA,color_vertex:nA,common:iA,defaultnormal_vertex:sA,displacementmap_pars_vertex:rA,displacementmap_vertex:oA,emissivemap_fragment:aA,emissivemap_pars_fragment:lA,colorspace_fragment:cA,colorspace_pars_fragment:hA,envmap_fragment:uA,envmap_common_pars_fragment:dA,envmap_pars_fragment:fA,envmap_pars_vertex:pA,envmap_physical_pars_fragment:EA,envmap_vertex:mA,fog_vertex:gA,fog_pars_vertex:xA,fog_fragment:vA,fog_pars_fragment:yA,gradientmap_pars_fragment:_A,lightmap_pars_fragment:wA,lights_lambert_fragment:bA,lights_lambert_pars_fragment:MA,lights_pars_begin:SA,lights_toon_fragment:TA,lights_toon_pars_fragment:AA,lights_phong_fragment:RA,lights_phong_pars_fragment:CA,lights_physical_fragment:IA,lights_physical_pars_fragment:PA,lights_fragment_begin:LA,lights_fragment_maps:NA,lights_fragment_end:DA,lightprobes_pars_fragment:OA,logdepthbuf_fragment:FA,logdepthbuf_pars_fragment:UA,logdepthbuf_pars_vertex:kA,logdepthbuf_vertex:BA,map_fragment:zA,map_pars_fragment:HA,map_particle_fragment:VA,map_particle_pars_fragment:GA,metalnessmap_fragment:WA,metalnessmap_pars_fragment:$A,morphinstance_vertex:XA,morphcolor_vertex:qA,morphnormal_vertex:YA,morphtarget_pars_vertex:KA,morphtarget_vertex:ZA,normal_fragment_begin:JA,normal_fragment_maps:jA,normal_pars_fragment:QA,normal_pars_vertex:tR,normal_vertex:eR,normalmap_pars_fragment:nR,clearcoat_normal_fragment_begin:iR,clearcoat_normal_fragment_maps:sR,clearcoat_pars_fragment:rR,iridescence_pars_fragment:oR,opaque_fragment:aR,packing:lR,premultiplied_alpha_fragment:cR,project_vertex:hR,dithering_fragment:uR,dithering_pars_fragment:dR,roughnessmap_fragment:fR,roughnessmap_pars_fragment:pR,shadowmap_pars_fragment:mR,shadowmap_pars_vertex:gR,shadowmap_vertex:xR,shadowmask_pars_fragment:vR,skinbase_vertex:yR,skinning_pars_vertex:_R,skinning_vertex:wR,skinnormal_vertex:bR,specularmap_fragment:MR,specularmap_pars_fragment:SR,tonemapping_fragment:ER,tonemapping_pars_fragment:TR,transmission_fragment:AR,transmission_pars_fragment:RR,uv_pars_fragment:CR,uv_pars_vertex:IR,uv_vertex:PR,worldpos_vertex:LR,background_vert:NR,background_frag:DR,backgroundCube_vert:OR,backgroundCube_frag:FR,cube_vert:UR,cube_frag:kR,depth_vert:BR,depth_frag:zR,distance_vert:HR,distance_frag:VR,equirect_vert:GR,equirect_frag:WR,linedashed_vert:$R,linedashed_frag:XR,meshbasic_vert:qR,meshbasic_frag:YR,meshlambert_vert:KR,meshlambert_frag:ZR,meshmatcap_vert:JR,meshmatcap_frag:jR,meshnormal_vert:QR,meshnormal_frag:tC,meshphong_vert:eC,meshphong_frag:nC,meshphysical_vert:iC,meshphysical_frag:sC,meshtoon_vert:rC,meshtoon_frag:oC,points_vert:aC,points_frag:lC,shadow_vert:cC,shadow_frag:hC,sprite_vert:uC,sprite_frag:dC},Nt={common:{diffuse:{value:new we(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ie}},envmap:{envMap:{value:null},envMapRotation:{value:new ie},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ie}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ie}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ie},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ie},normalScale:{value:new xe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ie},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ie}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ie}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ie}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new we(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new we(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0},uvTransform:{value:new ie}},sprite:{diffuse:{value:new we(16777215)},opacity:{value:1},center:{value:new xe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}}},us={basic:{uniforms:Xn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.fog]),vertexShader:de.meshbasic_vert,fragmentShader:de.meshbasic_frag},lambert:{uniforms:Xn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new we(0)},envMapIntensity:{value:1}}]),vertexShader:de.meshlambert_vert,fragmentShader:de.meshlambert_frag},phong:{uniforms:Xn([Nt.common,Nt.specularmap,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,Nt.lights,{emissive:{value:new we(0)},specular:{value:new we(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:de.meshphong_vert,fragmentShader:de.meshphong_frag},standard:{uniforms:Xn([Nt.common,Nt.envmap,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.roughnessmap,Nt.metalnessmap,Nt.fog,Nt.lights,{emissive:{value:new we(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:de.meshphysical_vert,fragmentShader:de.meshphysical_frag},toon:{uniforms:Xn([Nt.common,Nt.aomap,Nt.lightmap,Nt.emissivemap,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.gradientmap,Nt.fog,Nt.lights,{emissive:{value:new we(0)}}]),vertexShader:de.meshtoon_vert,fragmentShader:de.meshtoon_frag},matcap:{uniforms:Xn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,Nt.fog,{matcap:{value:null}}]),vertexShader:de.meshmatcap_vert,fragmentShader:de.meshmatcap_frag},points:{uniforms:Xn([Nt.points,Nt.fog]),vertexShader:de.points_vert,fragmentShader:de.points_frag},dashed:{uniforms:Xn([Nt.common,Nt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:de.linedashed_vert,fragmentShader:de.linedashed_frag},depth:{uniforms:Xn([Nt.common,Nt.displacementmap]),vertexShader:de.depth_vert,fragmentShader:de.depth_frag},normal:{uniforms:Xn([Nt.common,Nt.bumpmap,Nt.normalmap,Nt.displacementmap,{opacity:{value:1}}]),vertexShader:de.meshnormal_vert,fragmentShader:de.meshnormal_frag},sprite:{uniforms:Xn([Nt.sprite,Nt.fog]),vertexShader:de.sprite_vert,fragmentShader:de.sprite_frag},background:{uniforms:{uvTransform:{value:new ie},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:de.background_vert,fragmentShader:de.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ie}},vertexShader:de.backgroundCube_vert,fragmentShader:de.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:de.cube_vert,fragmentShader:de.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:de.equirect_vert,fragmentShader:de.equirect_frag},distance:{uniforms:Xn([Nt.common,Nt.displacementmap,{referencePosition:{value:new J},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:de.distance_vert,fragmentShader:de.distance_frag},shadow:{uniforms:Xn([Nt.lights,Nt.fog,{color:{value:new we(0)},opacity:{value:1}}]),vertexShader:de.shadow_vert,fragmentShader:de.shadow_frag}};us.physical={uniforms:Xn([us.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ie},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ie},clearcoatNormalScale:{value:new xe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ie},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ie},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ie},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ie},sheen:{value:0},sheenColor:{value:new we(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ie},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ie},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ie},transmissionSamplerSize:{value:new xe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ie},attenuationDistance:{value:0},attenuationColor:{value:new we(0)},specularColor:{value:new we(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ie},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ie},anisotropyVector:{value:new xe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ie}}]),vertexShader:de.meshphysical_vert,fragmentShader:de.meshphysical_frag};var Hu={r:0,b:0,g:0},fC=new Ge,Uy=new ie;Uy.set(-1,0,0,0,1,0,0,0,1);function pC(i,t,e,n,s,r){let o=new we(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(v){let M=v.isScene===!0?v.background:null;if(M&&M.isTexture){let w=v.backgroundBlurriness>0;M=t.get(M,w)}return M}function p(v){let M=!1,w=f(v);w===null?g(o,a):w&&w.isColor&&(g(w,1),M=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(v,M){let w=f(M);w&&w.isCubeTexture?(c===void 0&&(c=new nn(new $o(1,1,1),new ls({name:"BackgroundCubeMaterial",uniforms:Hr(us.backgroundCube.uniforms),vertexShader:us.backgroundCube.vertexShader,fragmentShader:us.backgroundCube.fragmentShader,side:ei,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,T,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=w,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(fC.makeRotationFromEuler(M.backgroundRotation)).transpose(),w.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Uy),c.material.toneMapped=_e.getTransfer(w.colorSpace)!==Pe,(h!==w||u!==w.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=w,u=w.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):w&&w.isTexture&&(l===void 0&&(l=new nn(new tl(2,2),new ls({name:"BackgroundMaterial",uniforms:Hr(us.background.uniforms),vertexShader:us.background.vertexShader,fragmentShader:us.background.fragmentShader,side:rr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=w,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=_e.getTransfer(w.colorSpace)!==Pe,w.matrixAutoUpdate===!0&&w.updateMatrix(),l.material.uniforms.uvTransform.value.copy(w.matrix),(h!==w||u!==w.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=w,u=w.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function g(v,M){v.getRGB(Hu,qp(i)),e.buffers.color.setClear(Hu.r,Hu.g,Hu.b,M,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,M=1){o.set(v),a=M,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,g(o,a)},render:p,addToRenderList:x,dispose:m}}function mC(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(P,G,W,D,V){let $=!1,k=u(P,D,W,G);r!==k&&(r=k,c(r.object)),$=f(P,D,W,V),$&&p(P,D,W,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,w(P,G,W,D),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return i.createVertexArray()}function c(P){return i.bindVertexArray(P)}function h(P){return i.deleteVertexArray(P)}function u(P,G,W,D){let V=D.wireframe===!0,$=n[G.id];$===void 0&&($={},n[G.id]=$);let k=P.isInstancedMesh===!0?P.id:0,ot=$[k];ot===void 0&&(ot={},$[k]=ot);let K=ot[W.id];K===void 0&&(K={},ot[W.id]=K);let Q=K[V];return Q===void 0&&(Q=d(l()),K[V]=Q),Q}function d(P){let G=[],W=[],D=[];for(let V=0;V<e;V++)G[V]=0,W[V]=0,D[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:W,attributeDivisors:D,object:P,attributes:{},index:null}}function f(P,G,W,D){let V=r.attributes,$=G.attributes,k=0,ot=W.getAttributes();for(let K in ot)if(ot[K].location>=0){let st=V[K],ft=$[K];if(ft===void 0&&(K==="instanceMatrix"&&P.instanceMatrix&&(ft=P.instanceMatrix),K==="instanceColor"&&P.instanceColor&&(ft=P.instanceColor)),st===void 0||st.attribute!==ft||ft&&st.data!==ft.data)return!0;k++}return r.attributesNum!==k||r.index!==D}function p(P,G,W,D){let V={},$=G.attributes,k=0,ot=W.getAttributes();for(let K in ot)if(ot[K].location>=0){let st=$[K];st===void 0&&(K==="instanceMatrix"&&P.instanceMatrix&&(st=P.instanceMatrix),K==="instanceColor"&&P.instanceColor&&(st=P.instanceColor));let ft={};ft.attribute=st,st&&st.data&&(ft.data=st.data),V[K]=ft,k++}r.attributes=V,r.attributesNum=k,r.index=D}function x(){let P=r.newAttributes;for(let G=0,W=P.length;G<W;G++)P[G]=0}function g(P){m(P,0)}function m(P,G){let W=r.newAttributes,D=r.enabledAttributes,V=r.attributeDivisors;W[P]=1,D[P]===0&&(i.enableVertexAttribArray(P),D[P]=1),V[P]!==G&&(i.vertexAttribDivisor(P,G),V[P]=G)}function v(){let P=r.newAttributes,G=r.enabledAttributes;for(let W=0,D=G.length;W<D;W++)G[W]!==P[W]&&(i.disableVertexAttribArray(W),G[W]=0)}function M(P,G,W,D,V,$,k){k===!0?i.vertexAttribIPointer(P,G,W,V,$):i.vertexAttribPointer(P,G,W,D,V,$)}function w(P,G,W,D){x();let V=D.attributes,$=W.getAttributes(),k=G.defaultAttributeValues;for(let ot in $){let K=$[ot];if(K.location>=0){let Q=V[ot];if(Q===void 0&&(ot==="instanceMatrix"&&P.instanceMatrix&&(Q=P.instanceMatrix),ot==="instanceColor"&&P.instanceColor&&(Q=P.instanceColor)),Q!==void 0){let st=Q.normalized,ft=Q.itemSize,dt=t.get(Q);if(dt===void 0)continue;let tt=dt.buffer,gt=dt.type,yt=dt.bytesPerElement,Rt=gt===i.INT||gt===i.UNSIGNED_INT||Q.gpuType===ou;if(Q.isInterleavedBufferAttribute){let Mt=Q.data,qt=Mt.isInterleavedBuffer===!0?Mt.stride:Mt.itemSize,oe=Q.offset;if(Mt.isInstancedInterleavedBuffer||Mt.isInstancedBufferAttribute){for(let Wt=0;Wt<K.locationSize;Wt++)m(K.location+Wt,Mt.meshPerAttribute);P.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Mt.meshPerAttribute*Mt.count)}else for(let Wt=0;Wt<K.locationSize;Wt++)g(K.location+Wt);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let Wt=0;Wt<K.locationSize;Wt++)M(K.location+Wt,ft/K.locationSize,gt,st,qt*yt,(oe+ft/K.locationSize*Wt)*yt,Rt)}else{if(Q.isInstancedBufferAttribute){for(let Mt=0;Mt<K.locationSize;Mt++)m(K.location+Mt,Q.meshPerAttribute);P.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Mt=0;Mt<K.locationSize;Mt++)g(K.location+Mt);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let Mt=0;Mt<K.locationSize;Mt++)M(K.location+Mt,ft/K.locationSize,gt,st,ft*yt,ft/K.locationSize*Mt*yt,Rt)}}else if(k!==void 0){let st=k[ot];if(st!==void 0)switch(st.length){case 2:i.vertexAttrib2fv(K.location,st);break;case 3:i.vertexAttrib3fv(K.location,st);break;case 4:i.vertexAttrib4fv(K.location,st);break;default:i.vertexAttrib1fv(K.location,st)}}}}v()}function R(){U();for(let P in n){let G=n[P];for(let W in G){let D=G[W];for(let V in D){let $=D[V];for(let k in $)h($[k].object),delete $[k];delete D[V]}}delete n[P]}}function T(P){if(n[P.id]===void 0)return;let G=n[P.id];for(let W in G){let D=G[W];for(let V in D){let $=D[V];for(let k in $)h($[k].object),delete $[k];delete D[V]}}delete n[P.id]}function y(P){for(let G in n){let W=n[G];for(let D in W){let V=W[D];if(V[P.id]===void 0)continue;let $=V[P.id];for(let k in $)h($[k].object),delete $[k];delete V[P.id]}}}function A(P){for(let G in n){let W=n[G],D=P.isInstancedMesh===!0?P.id:0,V=W[D];if(V!==void 0){for(let $ in V){let k=V[$];for(let ot in k)h(k[ot].object),delete k[ot];delete V[$]}delete W[D],Object.keys(W).length===0&&delete n[G]}}}function U(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:N,dispose:R,releaseStatesOfGeometry:T,releaseStatesOfObject:A,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:g,disableUnusedAttributes:v}}function gC(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function xC(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Vn&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let A=y===Wi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==xi&&y!==Hn&&!A&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(jt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),w=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),T=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:v,maxVaryings:M,maxFragmentUniforms:w,maxSamples:R,samples:T}}function vC(i){let t=this,e=null,n=0,s=!1,r=!1,o=new Vi,a=new ie,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,x=u.clipIntersection,g=u.clipShadows,m=i.get(u);if(!s||p===null||p.length===0||r&&!g)r?h(null):c();else{let v=r?0:n,M=v*4,w=m.clippingState||null;l.value=w,w=h(p,d,M,f);for(let R=0;R!==M;++R)w[R]=e[R];m.clippingState=w,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,p){let x=u!==null?u.length:0,g=null;if(x!==0){if(g=l.value,p!==!0||g===null){let m=f+x*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(g===null||g.length<m)&&(g=new Float32Array(m));for(let M=0,w=f;M!==x;++M,w+=4)o.copy(u[M]).applyMatrix4(v,a),o.normal.toArray(g,w),g[w+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,g}}var gl=class extends zn{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Ja(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new $o(5,5,5),r=new ls({name:"CubemapFromEquirect",uniforms:Hr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ei,blending:Rs});r.uniforms.tEquirect.value=e;let o=new nn(s,r),a=e.minFilter;return e.minFilter===Cs&&(e.minFilter=kn),new qo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},my=256,yC=3,_C=20,ky=256,By=16,wC=3,bC=new J,MC=new we,Gu=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new qo(1,10,null),this._boxMesh=new nn(new $o(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=bC}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(MC));let g=new qo(n,s,h);return g.position.copy(a),g.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=vy(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=xy(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(my,hy(t))}_fromTexture(t,e){t.mapping===Br||t.mapping===Zo?this._setSize(t.image.length===0?my:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=gy(t,!1,!1),n=Math.log2(t)-yC;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=gy(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Br||t.mapping===Zo?(this._cubemapMaterial===null&&(this._cubemapMaterial=vy()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=xy()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=SC(),this._integrationMaterial=EC());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/By);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-wC)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(ky*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=TC());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function gy(i,t,e){return new gl(i,{minFilter:Cs,generateMipmaps:t,type:Wi,colorSpace:js,depthBuffer:e})}function xl(i,t,e){return new ls({name:i,uniforms:t,vertexShader:de.cube_vert,fragmentShader:e,side:ei,blending:Rs,depthTest:!1,depthWrite:!1})}function SC(){return xl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${ky}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function EC(){return xl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:By}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function TC(){return xl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${_C}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function xy(){return xl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function vy(){return xl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function AC(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===iu||f===su)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new gl(p.height);return x.fromEquirectangularTexture(i,d),t.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===iu||f===su,x=f===Br||f===Zo;if(p||x){let g=e.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new Gu(i)),g=p?n.fromEquirectangular(d,g):n.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),g.texture;if(g!==void 0)return g.texture;{let v=d.image;return p&&v&&v.height>0||x&&v&&l(v)?(n===null&&(n=new Gu(i)),g=p?n.fromEquirectangular(d):n.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),d.addEventListener("dispose",h),g.texture):null}}}return d}function a(d,f){return f===iu?d.mapping=Br:f===su&&(d.mapping=Zo),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function RC(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&Ha("WebGLRenderer: "+n+" extension not supported."),s}}}function CC(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let g in p.attributes)t.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(p){let x=p.attributes;for(let g in x)t.update(x[g],i.ARRAY_BUFFER)}function u(p){let x=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let v=x!==null?x.array.length:g.array.length/3-1,M=g.count>=65535?Ka:Ya,w=new M(Math.ceil(v/3)*6,1),R=w.array;if(x!==null){let y=x.array;m=x.version;for(let A=0,U=0;A<v;A+=3){let N=y[A+0],P=y[A+1],G=y[A+2];R[U++]=N,R[U++]=P,R[U++]=P,R[U++]=G,R[U++]=G,R[U++]=N}}else{m=g.version;for(let y=0,A=0;y<v;y+=3){let U=y+0,N=y+1,P=y+2;R[A++]=U,R[A++]=N,R[A++]=N,R[A++]=P,R[A++]=P,R[A++]=U}}w.version=m;let T=r.get(p);T&&t.remove(T),r.set(p,w)}function d(p){let x=r.get(p);if(x){let g=p.index;g!==null&&x.version<g.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function IC(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),e.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let x=0;for(let g=0;g<f;g++)x+=d[g];e.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function PC(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:ne("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function LC(i,t,e){let n=new WeakMap,s=new We;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let U=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",U)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],M=0;f===!0&&(M=1),p===!0&&(M=2),x===!0&&(M=3);let w=a.attributes.position.count*M,R=1;w>t.maxTextureSize&&(R=Math.ceil(w/t.maxTextureSize),w=t.maxTextureSize);let T=new Float32Array(w*R*4*u),y=new Xa(T,w,R,u);y.type=Hn,y.needsUpdate=!0;let A=M*4;for(let N=0;N<u;N++){let P=g[N],G=m[N],W=v[N],D=w*R*4*N;for(let V=0;V<P.count;V++){let $=V*A;f===!0&&(s.fromBufferAttribute(P,V),T[D+$+0]=s.x,T[D+$+1]=s.y,T[D+$+2]=s.z,T[D+$+3]=0),p===!0&&(s.fromBufferAttribute(G,V),T[D+$+4]=s.x,T[D+$+5]=s.y,T[D+$+6]=s.z,T[D+$+7]=0),x===!0&&(s.fromBufferAttribute(W,V),T[D+$+8]=s.x,T[D+$+9]=s.y,T[D+$+10]=s.z,T[D+$+11]=W.itemSize===4?s.w:1)}}d={count:u,texture:y,size:new xe(w,R)},n.set(a,d),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function NC(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var DC={[Tp]:"LINEAR_TONE_MAPPING",[Ap]:"REINHARD_TONE_MAPPING",[Rp]:"CINEON_TONE_MAPPING",[Cp]:"ACES_FILMIC_TONE_MAPPING",[Pp]:"AGX_TONE_MAPPING",[Lp]:"NEUTRAL_TONE_MAPPING",[Ip]:"CUSTOM_TONE_MAPPING"};function OC(i,t,e,n,s,r){let o=new zn(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new en;h.setAttribute("position",new Ai([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Ai([0,2,0,0,2,0],2));let u=new Xo({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new nn(h,u),f=new Qh(-1,1,1,-1,0,1),p=null,x=null,g=!1,m,v=null,M=[],w=!1;this.setSize=function(R,T){o.setSize(R,T),a!==null&&a.setSize(R,T),l!==null&&l.setSize(R,T);for(let y=0;y<M.length;y++){let A=M[y];A.setSize&&A.setSize(R,T)}},this.setEffects=function(R){M=R,w=M.length>0&&M[0].isRenderPass===!0;let T=o.width,y=o.height;M.length>0&&a===null&&(a=new zn(T,y,{type:Wi,depthBuffer:!1,stencilBuffer:!1}),l=new zn(T,y,{type:Wi,depthBuffer:!1,stencilBuffer:!1}));let A=s===!0&&M.some(U=>U.needsDepthTexture===!0);A!==(o.depthTexture!==null)&&(A===!0&&c===null&&(c=new As(T,y),r===!0&&(c.format=Is,c.type=zr)),o.dispose(),o.depthTexture=A?c:null,o.resolveDepthBuffer=A,o.storeMultisampledDepthBuffer=A);for(let U=0;U<M.length;U++){let N=M[U];N.setSize&&N.setSize(T,y),A&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(R,T){if(g||R.toneMapping===cs&&M.length===0)return!1;if(v=T,T!==null){let y=T.width,A=T.height;(o.width!==y||o.height!==A)&&this.setSize(y,A)}return w===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=cs,!0},this.hasRenderPass=function(){return w},this.end=function(R,T){R.toneMapping=m,g=!0;let y=o,A=a;for(let U=0;U<M.length;U++){let N=M[U];N.enabled!==!1&&(N.render(R,A,y,T),N.needsSwap!==!1&&(y=A,A=A===a?l:a))}if(p!==R.outputColorSpace||x!==R.toneMapping){p=R.outputColorSpace,x=R.toneMapping,u.defines={},_e.getTransfer(p)===Pe&&(u.defines.SRGB_TRANSFER="");let U=DC[x];U&&(u.defines[U]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,R.setRenderTarget(v),R.render(d,f),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var zy=new ii,Hy=new As(1,1),Vy=new ja(1),Gy=new Xa,Wy=new Uh,$y=new Ja,yy=[],_y=[],wy=new Float32Array(16),by=new Float32Array(9),My=new Float32Array(4);function ta(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=yy[s];if(r===void 0&&(r=new Float32Array(s),yy[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Cn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function In(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function $u(i,t){let e=_y[t];e===void 0&&(e=new Int32Array(t),_y[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function FC(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function UC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Cn(e,t))return;i.uniform2fv(this.addr,t),In(e,t)}}function kC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Cn(e,t))return;i.uniform3fv(this.addr,t),In(e,t)}}function BC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Cn(e,t))return;i.uniform4fv(this.addr,t),In(e,t)}}function zC(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Cn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),In(e,t)}else{if(Cn(e,n))return;My.set(n),i.uniformMatrix2fv(this.addr,!1,My),In(e,n)}}function HC(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Cn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),In(e,t)}else{if(Cn(e,n))return;by.set(n),i.uniformMatrix3fv(this.addr,!1,by),In(e,n)}}function VC(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Cn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),In(e,t)}else{if(Cn(e,n))return;wy.set(n),i.uniformMatrix4fv(this.addr,!1,wy),In(e,n)}}function GC(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function WC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Cn(e,t))return;i.uniform2iv(this.addr,t),In(e,t)}}function $C(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Cn(e,t))return;i.uniform3iv(this.addr,t),In(e,t)}}function XC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Cn(e,t))return;i.uniform4iv(this.addr,t),In(e,t)}}function qC(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function YC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Cn(e,t))return;i.uniform2uiv(this.addr,t),In(e,t)}}function KC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Cn(e,t))return;i.uniform3uiv(this.addr,t),In(e,t)}}function ZC(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Cn(e,t))return;i.uniform4uiv(this.addr,t),In(e,t)}}function Xu(i){return i.version===0&&(i.compareFunction=Wp,i.needsUpdate=!0),i}function JC(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Xu(Hy):r=zy,e.setTexture2D(t||r,s)}function jC(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Wy,s)}function QC(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Xu(Vy):r=$y,e.setTextureCube(t||r,s)}function t2(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Gy,s)}function e2(i){switch(i){case 5126:return FC;case 35664:return UC;case 35665:return kC;case 35666:return BC;case 35674:return zC;case 35675:return HC;case 35676:return VC;case 5124:case 35670:return GC;case 35667:case 35671:return WC;case 35668:case 35672:return $C;case 35669:case 35673:return XC;case 5125:return qC;case 36294:return YC;case 36295:return KC;case 36296:return ZC;case 35678:case 36198:case 36298:case 36306:case 35682:return JC;case 35679:case 36299:case 36307:return jC;case 35680:case 36300:case 36308:case 36293:return QC;case 36289:case 36303:case 36311:case 36292:return t2}}function n2(i,t){i.uniform1fv(this.addr,t)}function i2(i,t){let e=ta(t,this.size,2);i.uniform2fv(this.addr,e)}function s2(i,t){let e=ta(t,this.size,3);i.uniform3fv(this.addr,e)}function r2(i,t){let e=ta(t,this.size,4);i.uniform4fv(this.addr,e)}function o2(i,t){let e=ta(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function a2(i,t){let e=ta(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function l2(i,t){let e=ta(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function c2(i,t){i.uniform1iv(this.addr,t)}function h2(i,t){i.uniform2iv(this.addr,t)}function u2(i,t){i.uniform3iv(this.addr,t)}function d2(i,t){i.uniform4iv(this.addr,t)}function f2(i,t){i.uniform1uiv(this.addr,t)}function p2(i,t){i.uniform2uiv(this.addr,t)}function m2(i,t){i.uniform3uiv(this.addr,t)}function g2(i,t){i.uniform4uiv(this.addr,t)}function x2(i,t,e){let n=this.cache,s=t.length,r=$u(e,s);Cn(n,r)||(i.uniform1iv(this.addr,r),In(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Xu(Hy):o=zy;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function v2(i,t,e){let n=this.cache,s=t.length,r=$u(e,s);Cn(n,r)||(i.uniform1iv(this.addr,r),In(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Wy,r[o])}function y2(i,t,e){let n=this.cache,s=t.length,r=$u(e,s);Cn(n,r)||(i.uniform1iv(this.addr,r),In(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Xu(Vy):o=$y;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function _2(i,t,e){let n=this.cache,s=t.length,r=$u(e,s);Cn(n,r)||(i.uniform1iv(this.addr,r),In(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Gy,r[o])}function w2(i){switch(i){case 5126:return n2;case 35664:return i2;case 35665:return s2;case 35666:return r2;case 35674:return o2;case 35675:return a2;case 35676:return l2;case 5124:case 35670:return c2;case 35667:case 35671:return h2;case 35668:case 35672:return u2;case 35669:case 35673:return d2;case 5125:return f2;case 36294:return p2;case 36295:return m2;case 36296:return g2;case 35678:case 36198:case 36298:case 36306:case 35682:return x2;case 35679:case 36299:case 36307:return v2;case 35680:case 36300:case 36308:case 36293:return y2;case 36289:case 36303:case 36311:case 36292:return _2}}var Qp=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=e2(e.type)}},tm=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=w2(e.type)}},em=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Jp=/(\w+)(\])?(\[|\.)?/g;function Sy(i,t){i.seq.push(t),i.map[t.id]=t}function b2(i,t,e){let n=i.name,s=n.length;for(Jp.lastIndex=0;;){let r=Jp.exec(n),o=Jp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Sy(e,c===void 0?new Qp(a,i,t):new tm(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new em(a),Sy(e,u)),e=u}}}var Qo=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);b2(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function Ey(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var M2=37297,S2=0;function E2(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var Ty=new ie;function T2(i){_e._getMatrix(Ty,_e.workingColorSpace,i);let t=`mat3( ${Ty.elements.map(e=>e.toFixed(4))} )`;switch(_e.getTransfer(i)){case Ga:return[t,"LinearTransferOETF"];case Pe:return[t,"sRGBTransferOETF"];default:return jt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Ay(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+E2(i.getShaderSource(t),a)}else return r}function A2(i,t){let e=T2(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var R2={[Tp]:"Linear",[Ap]:"Reinhard",[Rp]:"Cineon",[Cp]:"ACESFilmic",[Pp]:"AgX",[Lp]:"Neutral",[Ip]:"Custom"};function C2(i,t){let e=R2[t];return e===void 0?(jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Vu=new J;function I2(){_e.getLuminanceCoefficients(Vu);let i=Vu.x.toFixed(4),t=Vu.y.toFixed(4),e=Vu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function P2(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ml).join(`
`)}function L2(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function N2(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function ml(i){return i!==""}function Ry(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Cy(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var D2=/^[ \t]*#include +<([\w\d./]+)>/gm;function nm(i){return i.replace(D2,O2)}function O2(i,t){let e=de[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return nm(e)}var F2=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Iy(i){return i.replace(F2,U2)}function U2(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Py(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var k2={[nl]:"SHADOWMAP_TYPE_PCF",[Yo]:"SHADOWMAP_TYPE_VSM"};function B2(i){return k2[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var z2={[Zo]:"ENVMAP_MODE_REFRACTION"};function H2(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":z2[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var V2={[Ep]:"ENVMAP_BLENDING_MULTIPLY",[Yv]:"ENVMAP_BLENDING_MIX",[Kv]:"ENVMAP_BLENDING_ADD"};function G2(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":V2[i.combine]||"ENVMAP_BLENDING_NONE"}function W2(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=B2(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=H2(e),u=G2(e),d=P2(e),f=L2(r),p=s.createProgram(),x,g,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(ml).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(ml).join(`
`),g.length>0&&(g+=`
`)):(x=[Py(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ml).join(`
`),g=[Py(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==cs?"#define TONE_MAPPING":"",e.toneMapping!==cs?de.tonemapping_pars_fragment:"",e.toneMapping!==cs?C2("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",de.colorspace_pars_fragment,A2("linearToOutputTexel",e.outputColorSpace),I2(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(ml).join(`
`)),o=nm(o),o=Ry(o,e),o=Cy(o,e),a=nm(a),a=Ry(a,e),a=Cy(a,e),o=Iy(o),a=Iy(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",e.glslVersion===dl?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===dl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let v=m+x+o,M=m+g+a,w=Ey(s,s.VERTEX_SHADER,v),R=Ey(s,s.FRAGMENT_SHADER,M);s.attachShader(p,w),s.attachShader(p,R),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function T(N){if(i.debug.checkShaderErrors){let P=s.getProgramInfoLog(p)||"",G=s.getShaderInfoLog(w)||"",W=s.getShaderInfoLog(R)||"",D=P.trim(),V=G.trim(),$=W.trim(),k=!0,ot=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(k=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,w,R);else{let K=Ay(s,w,"vertex"),Q=Ay(s,R,"fragment");ne("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+D+`
`+K+`
`+Q)}else D!==""?jt("WebGLProgram: Program Info Log:",D):(V===""||$==="")&&(ot=!1);ot&&(N.diagnostics={runnable:k,programLog:D,vertexShader:{log:V,prefix:x},fragmentShader:{log:$,prefix:g}})}s.deleteShader(w),s.deleteShader(R),y=new Qo(s,p),A=N2(s,p)}let y;this.getUniforms=function(){return y===void 0&&T(this),y};let A;this.getAttributes=function(){return A===void 0&&T(this),A};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,M2)),U},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=S2++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=w,this.fragmentShader=R,this}var $2=0,im=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new sm(t),e.set(t,n)),n}},sm=class{constructor(t){this.id=$2++,this.code=t,this.usedTimes=0}};function X2(i){return i===or||i===cl||i===hl}function q2(i,t,e,n,s,r){let o=new qa,a=new im,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,A,U,N,P,G){let W=N.fog,D=P.geometry,V=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?N.environment:null,$=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,k=t.get(y.envMap||V,$),ot=d[y.type],K=n.precision;y.precision!==null&&(K=n.getMaxPrecision(y.precision),K!==y.precision&&jt("WebGLProgram.getParameters:",y.precision,"not supported, using",K,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,st=Q!==void 0?Q.length:0,ft=0;D.morphAttributes.position!==void 0&&(ft=1),D.morphAttributes.normal!==void 0&&(ft=2),D.morphAttributes.color!==void 0&&(ft=3);let dt,tt,gt,yt;if(ot){let Ct=us[ot];dt=Ct.vertexShader,tt=Ct.fragmentShader}else{dt=y.vertexShader,tt=y.fragmentShader;let Ct=a.getVertexShaderStage(y),le=a.getFragmentShaderStage(y);a.update(y,Ct,le),gt=Ct.id,yt=le.id}let Rt=i.getRenderTarget(),Mt=i.state.buffers.depth.getReversed(),qt=P.isInstancedMesh===!0,oe=P.isBatchedMesh===!0,Wt=!!y.map,fe=!!y.matcap,he=!!k,se=he&&k.isPMREMTexture===!0,Je=!!y.aoMap,Ve=!!y.lightMap,mn=!!y.bumpMap&&y.wireframe===!1,Oe=!!y.normalMap,Ln=!!y.displacementMap,Se=!!y.emissiveMap,Sn=!!y.metalnessMap,on=!!y.roughnessMap,gn=y.anisotropy>0,F=y.clearcoat>0,It=y.diffuseRoughness>0,Zt=y.dispersion>0,ae=y.retroreflectivity>0,St=y.iridescence>0,ke=y.sheen>0,Gt=y.transmission>0,Kt=gn&&!!y.anisotropyMap,C=F&&!!y.clearcoatMap,b=F&&!!y.clearcoatNormalMap,X=F&&!!y.clearcoatRoughnessMap,ut=It&&!!y.diffuseRoughnessMap,at=St&&!!y.iridescenceMap,vt=St&&!!y.iridescenceThicknessMap,_t=ke&&!!y.sheenColorMap,et=ke&&!!y.sheenRoughnessMap,it=!!y.specularMap,mt=!!y.specularColorMap,O=!!y.specularIntensityMap,rt=Gt&&!!y.transmissionMap,nt=Gt&&!!y.thicknessMap,Et=!!y.gradientMap,xt=!!y.alphaMap,bt=y.alphaTest>0,Xt=!!y.alphaHash,Qt=!!y.extensions,ht=cs;y.toneMapped&&(Rt===null||Rt.isXRRenderTarget===!0)&&(ht=i.toneMapping);let Bt=se?k.isCompressedCubeTexture?k.image[0].mipmaps:k.mipmaps:null,te={shaderID:ot,shaderType:y.type,shaderName:y.name,vertexShader:dt,fragmentShader:tt,defines:y.defines,customVertexShaderID:gt,customFragmentShaderID:yt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:K,batching:oe,batchingColor:oe&&P._colorsTexture!==null,instancing:qt,instancingColor:qt&&P.instanceColor!==null,instancingMorph:qt&&P.morphTexture!==null,outputColorSpace:Rt===null?i.outputColorSpace:Rt.isXRRenderTarget===!0?Rt.texture.colorSpace:_e.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Wt,matcap:fe,envMap:he,envMapMode:he&&k.mapping,envMapPMREM:se,envMapMaxLod:se?Bt.length-1:null,envMapSize:se?Bt[0].width:null,aoMap:Je,lightMap:Ve,bumpMap:mn,normalMap:Oe,displacementMap:Ln,emissiveMap:Se,normalMapObjectSpace:Oe&&y.normalMapType===jv,normalMapTangentSpace:Oe&&y.normalMapType===Hp,packedNormalMap:Oe&&y.normalMapType===Hp&&X2(y.normalMap.format),metalnessMap:Sn,roughnessMap:on,anisotropy:gn,anisotropyMap:Kt,clearcoat:F,clearcoatMap:C,clearcoatNormalMap:b,clearcoatRoughnessMap:X,diffuseRoughness:It,diffuseRoughnessMap:ut,dispersion:Zt,retroreflection:ae,iridescence:St,iridescenceMap:at,iridescenceThicknessMap:vt,sheen:ke,sheenColorMap:_t,sheenRoughnessMap:et,specularMap:it,specularColorMap:mt,specularIntensityMap:O,transmission:Gt,transmissionMap:rt,thicknessMap:nt,gradientMap:Et,opaque:y.transparent===!1&&y.blending===Ko&&y.alphaToCoverage===!1,alphaMap:xt,alphaTest:bt,alphaHash:Xt,combine:y.combine,mapUv:Wt&&f(y.map.channel),aoMapUv:Je&&f(y.aoMap.channel),lightMapUv:Ve&&f(y.lightMap.channel),bumpMapUv:mn&&f(y.bumpMap.channel),normalMapUv:Oe&&f(y.normalMap.channel),displacementMapUv:Ln&&f(y.displacementMap.channel),emissiveMapUv:Se&&f(y.emissiveMap.channel),metalnessMapUv:Sn&&f(y.metalnessMap.channel),roughnessMapUv:on&&f(y.roughnessMap.channel),anisotropyMapUv:Kt&&f(y.anisotropyMap.channel),clearcoatMapUv:C&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:b&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:at&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:vt&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:_t&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:et&&f(y.sheenRoughnessMap.channel),specularMapUv:it&&f(y.specularMap.channel),specularColorMapUv:mt&&f(y.specularColorMap.channel),specularIntensityMapUv:O&&f(y.specularIntensityMap.channel),transmissionMapUv:rt&&f(y.transmissionMap.channel),thicknessMapUv:nt&&f(y.thicknessMap.channel),alphaMapUv:xt&&f(y.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Oe||gn),vertexNormals:!!D.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!D.attributes.uv&&(Wt||xt),fog:!!W,useFog:y.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||D.attributes.normal===void 0&&Oe===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Mt,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:st,morphTextureStride:ft,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:G.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&U.length>0,shadowMapType:i.shadowMap.type,toneMapping:ht,decodeVideoTexture:Wt&&y.map.isVideoTexture===!0&&_e.getTransfer(y.map.colorSpace)===Pe,decodeVideoTextureEmissive:Se&&y.emissiveMap.isVideoTexture===!0&&_e.getTransfer(y.emissiveMap.colorSpace)===Pe,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Ri,flipSided:y.side===ei,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Qt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qt&&y.extensions.multiDraw===!0||oe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return te.vertexUv1s=l.has(1),te.vertexUv2s=l.has(2),te.vertexUv3s=l.has(3),l.clear(),te}function x(y){let A=[];if(y.shaderID?A.push(y.shaderID):(A.push(y.customVertexShaderID),A.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)A.push(U),A.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(g(A,y),m(A,y),A.push(i.outputColorSpace)),A.push(y.customProgramCacheKey),A.join()}function g(y,A){y.push(A.precision),y.push(A.outputColorSpace),y.push(A.envMapMode),y.push(A.envMapPMREM),y.push(A.envMapMaxLod),y.push(A.envMapSize),y.push(A.mapUv),y.push(A.alphaMapUv),y.push(A.lightMapUv),y.push(A.aoMapUv),y.push(A.bumpMapUv),y.push(A.normalMapUv),y.push(A.displacementMapUv),y.push(A.emissiveMapUv),y.push(A.metalnessMapUv),y.push(A.roughnessMapUv),y.push(A.anisotropyMapUv),y.push(A.clearcoatMapUv),y.push(A.clearcoatNormalMapUv),y.push(A.clearcoatRoughnessMapUv),y.push(A.diffuseRoughnessMapUv),y.push(A.iridescenceMapUv),y.push(A.iridescenceThicknessMapUv),y.push(A.sheenColorMapUv),y.push(A.sheenRoughnessMapUv),y.push(A.specularMapUv),y.push(A.specularColorMapUv),y.push(A.specularIntensityMapUv),y.push(A.transmissionMapUv),y.push(A.thicknessMapUv),y.push(A.combine),y.push(A.fogExp2),y.push(A.sizeAttenuation),y.push(A.morphTargetsCount),y.push(A.numSunLights),y.push(A.numDirLights),y.push(A.numPointLights),y.push(A.numSpotLights),y.push(A.numSpotLightMaps),y.push(A.numHemiLights),y.push(A.numRectAreaLights),y.push(A.numSunLightShadows),y.push(A.numDirLightShadows),y.push(A.numPointLightShadows),y.push(A.numSpotLightShadows),y.push(A.numSpotLightShadowsWithMaps),y.push(A.numLightProbes),y.push(A.numLightProbeGrids),y.push(A.shadowMapType),y.push(A.toneMapping),y.push(A.numClippingPlanes),y.push(A.numClipIntersection),y.push(A.depthPacking)}function m(y,A){o.disableAll(),A.instancing&&o.enable(0),A.instancingColor&&o.enable(1),A.instancingMorph&&o.enable(2),A.matcap&&o.enable(3),A.envMap&&o.enable(4),A.normalMapObjectSpace&&o.enable(5),A.normalMapTangentSpace&&o.enable(6),A.clearcoat&&o.enable(7),A.iridescence&&o.enable(8),A.alphaTest&&o.enable(9),A.vertexColors&&o.enable(10),A.vertexAlphas&&o.enable(11),A.vertexUv1s&&o.enable(12),A.vertexUv2s&&o.enable(13),A.vertexUv3s&&o.enable(14),A.vertexTangents&&o.enable(15),A.anisotropy&&o.enable(16),A.alphaHash&&o.enable(17),A.batching&&o.enable(18),A.dispersion&&o.enable(19),A.retroreflection&&o.enable(24),A.diffuseRoughness&&o.enable(25),A.batchingColor&&o.enable(20),A.gradientMap&&o.enable(21),A.packedNormalMap&&o.enable(22),A.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),A.fog&&o.enable(0),A.useFog&&o.enable(1),A.flatShading&&o.enable(2),A.logarithmicDepthBuffer&&o.enable(3),A.reversedDepthBuffer&&o.enable(4),A.skinning&&o.enable(5),A.morphTargets&&o.enable(6),A.morphNormals&&o.enable(7),A.morphColors&&o.enable(8),A.premultipliedAlpha&&o.enable(9),A.shadowMapEnabled&&o.enable(10),A.doubleSided&&o.enable(11),A.flipSided&&o.enable(12),A.useDepthPacking&&o.enable(13),A.dithering&&o.enable(14),A.transmission&&o.enable(15),A.sheen&&o.enable(16),A.opaque&&o.enable(17),A.pointsUvs&&o.enable(18),A.decodeVideoTexture&&o.enable(19),A.decodeVideoTextureEmissive&&o.enable(20),A.alphaToCoverage&&o.enable(21),A.numLightProbeGrids>0&&o.enable(22),A.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function v(y){let A=d[y.type],U;if(A){let N=us[A];U=dy.clone(N.uniforms)}else U=y.uniforms;return U}function M(y,A){let U=h.get(A);return U!==void 0?++U.usedTimes:(U=new W2(i,A,y,s),c.push(U),h.set(A,U)),U}function w(y){if(--y.usedTimes===0){let A=c.indexOf(y);c[A]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function R(y){a.remove(y)}function T(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:v,acquireProgram:M,releaseProgram:w,releaseShaderCache:R,programs:c,dispose:T}}function Y2(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function K2(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Ly(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Ny(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,g,m){let v=i[t];return v===void 0?(v={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:g,group:m},i[t]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=p,v.materialVariant=o(d),v.groupOrder=x,v.renderOrder=d.renderOrder,v.z=g,v.group=m),t++,v}function l(d,f,p,x,g,m,v){v.reversedDepth===!0&&(g=-g);let M=a(d,f,p,x,g,m);p.transmission>0?n.push(M):p.transparent===!0?s.push(M):e.push(M)}function c(d,f,p,x,g,m){let v=a(d,f,p,x,g,m);p.transmission>0?n.unshift(v):p.transparent===!0?s.unshift(v):e.unshift(v)}function h(d,f){e.length>1&&e.sort(d||K2),n.length>1&&n.sort(f||Ly),s.length>1&&s.sort(f||Ly)}function u(){for(let d=t,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function Z2(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new Ny,i.set(n,[o])):s>=r.length?(o=new Ny,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function J2(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new J,color:new we};break;case"SpotLight":e={position:new J,direction:new J,color:new we,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new J,color:new we,distance:0,decay:0};break;case"HemisphereLight":e={direction:new J,skyColor:new we,groundColor:new we};break;case"RectAreaLight":e={color:new we,position:new J,halfWidth:new J,halfHeight:new J};break}return i[t.id]=e,e}}}function j2(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xe};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xe};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xe,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var Q2=0;function t3(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function e3(i){let t=new J2,e=j2(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new J);let s=new J,r=new Ge,o=new Ge;function a(c){let h=0,u=0,d=0;for(let G=0;G<9;G++)n.probe[G].set(0,0,0);let f=0,p=0,x=0,g=0,m=0,v=0,M=0,w=0,R=0,T=0,y=0,A=0,U=0,N=0;c.sort(t3);for(let G=0,W=c.length;G<W;G++){let D=c[G],V=D.color,$=D.intensity,k=D.distance,ot=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===or?ot=D.shadow.map.texture:ot=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=V.r*$,u+=V.g*$,d+=V.b*$;else if(D.isLightProbe){for(let K=0;K<9;K++)n.probe[K].addScaledVector(D.sh.coefficients[K],$);N++}else if(D.isSunLight){let K=t.get(D);if(K.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,st=e.get(D);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[p]=st,n.sunShadowMap[p]=ot;let ft=Q.getViewportCount();for(let dt=0;dt<ft;dt++)n.sunShadowMatrix[x+dt]=Q.getMatrix(dt),n.sunShadowCascade[x+dt]=Q._cascadeData[dt];x+=ft,p++}n.sun[f]=K,f++}else if(D.isDirectionalLight){let K=t.get(D);if(K.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,st=e.get(D);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,n.directionalShadow[g]=st,n.directionalShadowMap[g]=ot,n.directionalShadowMatrix[g]=D.shadow.matrix,R++}n.directional[g]=K,g++}else if(D.isSpotLight){let K=t.get(D);K.position.setFromMatrixPosition(D.matrixWorld),K.color.copy(V).multiplyScalar($),K.distance=k,K.coneCos=Math.cos(D.angle),K.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),K.decay=D.decay,n.spot[v]=K;let Q=D.shadow;if(D.map&&(n.spotLightMap[A]=D.map,A++,Q.updateMatrices(D),D.castShadow&&U++),n.spotLightMatrix[v]=Q.matrix,D.castShadow){let st=e.get(D);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,n.spotShadow[v]=st,n.spotShadowMap[v]=ot,y++}v++}else if(D.isRectAreaLight){let K=t.get(D);K.color.copy(V).multiplyScalar($),K.halfWidth.set(D.width*.5,0,0),K.halfHeight.set(0,D.height*.5,0),n.rectArea[M]=K,M++}else if(D.isPointLight){let K=t.get(D);if(K.color.copy(D.color).multiplyScalar(D.intensity),K.distance=D.distance,K.decay=D.decay,D.castShadow){let Q=D.shadow,st=e.get(D);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,st.shadowCameraNear=Q.camera.near,st.shadowCameraFar=Q.camera.far,n.pointShadow[m]=st,n.pointShadowMap[m]=ot,n.pointShadowMatrix[m]=D.shadow.matrix,T++}n.point[m]=K,m++}else if(D.isHemisphereLight){let K=t.get(D);K.skyColor.copy(D.color).multiplyScalar($),K.groundColor.copy(D.groundColor).multiplyScalar($),n.hemi[w]=K,w++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Nt.LTC_FLOAT_1,n.rectAreaLTC2=Nt.LTC_FLOAT_2):(n.rectAreaLTC1=Nt.LTC_HALF_1,n.rectAreaLTC2=Nt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let P=n.hash;(P.sunLength!==f||P.directionalLength!==g||P.pointLength!==m||P.spotLength!==v||P.rectAreaLength!==M||P.hemiLength!==w||P.numSunShadows!==p||P.numDirectionalShadows!==R||P.numPointShadows!==T||P.numSpotShadows!==y||P.numSpotMaps!==A||P.numLightProbes!==N)&&(n.sun.length=f,n.directional.length=g,n.spot.length=v,n.rectArea.length=M,n.point.length=m,n.hemi.length=w,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=T,n.pointShadowMap.length=T,n.pointShadowMatrix.length=T,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+A-U,n.spotLightMap.length=A,n.numSpotLightShadowsWithMaps=U,n.numLightProbes=N,P.sunLength=f,P.directionalLength=g,P.pointLength=m,P.spotLength=v,P.rectAreaLength=M,P.hemiLength=w,P.numSunShadows=p,P.numDirectionalShadows=R,P.numPointShadows=T,P.numSpotShadows=y,P.numSpotMaps=A,P.numLightProbes=N,n.version=Q2++)}function l(c,h){let u=0,d=0,f=0,p=0,x=0,g=0,m=h.matrixWorldInverse;for(let v=0,M=c.length;v<M;v++){let w=c[v];if(w.isSunLight){let R=n.sun[u];R.direction.setFromMatrixPosition(w.matrixWorld),R.direction.transformDirection(m),u++}else if(w.isDirectionalLight){let R=n.directional[d];R.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),d++}else if(w.isSpotLight){let R=n.spot[p];R.position.setFromMatrixPosition(w.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),p++}else if(w.isRectAreaLight){let R=n.rectArea[x];R.position.setFromMatrixPosition(w.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(w.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(w.width*.5,0,0),R.halfHeight.set(0,w.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),x++}else if(w.isPointLight){let R=n.point[f];R.position.setFromMatrixPosition(w.matrixWorld),R.position.applyMatrix4(m),f++}else if(w.isHemisphereLight){let R=n.hemi[g];R.direction.setFromMatrixPosition(w.matrixWorld),R.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:n}}function Dy(i){let t=new e3(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function n3(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Dy(i),t.set(s,[a])):r>=o.length?(a=new Dy(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var i3=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,s3=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,r3=[new J(1,0,0),new J(-1,0,0),new J(0,1,0),new J(0,-1,0),new J(0,0,1),new J(0,0,-1)],o3=[new J(0,-1,0),new J(0,-1,0),new J(0,0,1),new J(0,0,-1),new J(0,-1,0),new J(0,-1,0)],Oy=new Ge,pl=new J,jp=new J;function a3(i,t,e){let n=new Or,s=new xe,r=new xe,o=new We,a=new Hh,l=new Vh,c={},h=e.maxTextureSize,u={[rr]:ei,[ei]:rr,[Ri]:Ri},d=new ls({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new xe},radius:{value:4}},vertexShader:i3,fragmentShader:s3}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new en;p.setAttribute("position",new tn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new nn(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=nl;let m=this.type;this.render=function(T,y,A){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||T.length===0)return;this.type===Lv&&(jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=nl);let U=i.getRenderTarget(),N=i.getActiveCubeFace(),P=i.getActiveMipmapLevel(),G=i.state;G.setBlending(Rs),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let W=m!==this.type;W&&y.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(V=>V.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,V=T.length;D<V;D++){let $=T[D],k=$.shadow;if(k===void 0){jt("WebGLShadowMap:",$,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);let ot=k.getFrameExtents();s.multiply(ot),r.copy(k.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ot.x),s.x=r.x*ot.x,k.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ot.y),s.y=r.y*ot.y,k.mapSize.y=r.y));let K=i.state.buffers.depth.getReversed();if(k.camera._reversedDepth=K,k.map===null||W===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===Yo){if($.isPointLight){jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new zn(s.x,s.y,{format:or,type:Wi,minFilter:kn,magFilter:kn,generateMipmaps:!1}),k.map.texture.name=$.name+".shadowMap",k.map.depthTexture=new As(s.x,s.y,Hn),k.map.depthTexture.name=$.name+".shadowMapDepth",k.map.depthTexture.format=Ts,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=rn,k.map.depthTexture.magFilter=rn}else $.isPointLight?(k.map=new gl(s.x),k.map.depthTexture=new ja(s.x,vi)):(k.map=new zn(s.x,s.y),k.map.depthTexture=new As(s.x,s.y,vi)),k.map.depthTexture.name=$.name+".shadowMap",k.map.depthTexture.format=Ts,this.type===nl?(k.map.depthTexture.compareFunction=K?Gp:Vp,k.map.depthTexture.minFilter=kn,k.map.depthTexture.magFilter=kn):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=rn,k.map.depthTexture.magFilter=rn);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);let Q=k.map.isWebGLCubeRenderTarget?6:k.getViewportCount();$.isPointLight!==!0&&k.updateMatrices($,A);let st=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:A.layers;for(let ft=0;ft<Q;ft++){let dt=k.getCamera(ft);if($.isPointLight){let tt=k.camera,gt=k.matrix,yt=$.distance||tt.far;yt!==tt.far&&(tt.far=yt,tt.updateProjectionMatrix()),pl.setFromMatrixPosition($.matrixWorld),tt.position.copy(pl),jp.copy(tt.position),jp.add(r3[ft]),tt.up.copy(o3[ft]),tt.lookAt(jp),tt.updateMatrixWorld(),gt.makeTranslation(-pl.x,-pl.y,-pl.z),Oy.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),k._frustum.setFromProjectionMatrix(Oy,tt.coordinateSystem,tt.reversedDepth)}if(k.map.isWebGLCubeRenderTarget)i.setRenderTarget(k.map,ft),i.clear();else{ft===0&&(i.setRenderTarget(k.map),i.clear());let tt=k.getViewport(ft);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),G.viewport(o)}n=k.getFrustum(ft),w(y,A,dt,$,st,this.type)}k.isPointLightShadow!==!0&&this.type===Yo&&v(k,A),k.needsUpdate=!1}m=this.type,g.needsUpdate=!1,i.setRenderTarget(U,N,P)};function v(T,y){let A=t.update(x);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new zn(s.x,s.y,{format:or,type:Wi}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,i.setRenderTarget(T.mapPass),i.clear(),i.renderBufferDirect(y,null,A,d,x,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,i.setRenderTarget(T.map),i.clear(),i.renderBufferDirect(y,null,A,f,x,null)}function M(T,y,A,U){let N=null,P=A.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(P!==void 0)N=P;else if(N=A.isPointLight===!0?l:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let G=N.uuid,W=y.uuid,D=c[G];D===void 0&&(D={},c[G]=D);let V=D[W];V===void 0&&(V=N.clone(),D[W]=V,y.addEventListener("dispose",R)),N=V}if(N.visible=y.visible,N.wireframe=y.wireframe,U===Yo?N.side=y.shadowSide!==null?y.shadowSide:y.side:N.side=y.shadowSide!==null?y.shadowSide:u[y.side],N.alphaMap=y.alphaMap,N.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,N.map=y.map,N.clipShadows=y.clipShadows,N.clippingPlanes=y.clippingPlanes,N.clipIntersection=y.clipIntersection,N.displacementMap=y.displacementMap,N.displacementScale=y.displacementScale,N.displacementBias=y.displacementBias,N.wireframeLinewidth=y.wireframeLinewidth,N.linewidth=y.linewidth,A.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let G=i.properties.get(N);G.light=A}return N}function w(T,y,A,U,N,P){if(T.visible===!1)return;if(T.layers.test(N)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&P===Yo)&&(!T.frustumCulled||T.intersectsFrustum(n))){T.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,T.matrixWorld);let D=t.update(T),V=T.material;if(Array.isArray(V)){let $=D.groups;for(let k=0,ot=$.length;k<ot;k++){let K=$[k],Q=V[K.materialIndex];if(Q&&Q.visible){let st=M(T,Q,U,P);T.onBeforeShadow(i,T,y,A,D,st,K),i.renderBufferDirect(A,null,D,st,T,K),T.onAfterShadow(i,T,y,A,D,st,K)}}}else if(V.visible){let $=M(T,V,U,P);T.onBeforeShadow(i,T,y,A,D,$,null),i.renderBufferDirect(A,null,D,$,T,null),T.onAfterShadow(i,T,y,A,D,$,null)}}let W=T.children;for(let D=0,V=W.length;D<V;D++)w(W[D],y,A,U,N,P)}function R(T){T.target.removeEventListener("dispose",R);for(let A in c){let U=c[A],N=T.target.uuid;N in U&&(U[N].dispose(),delete U[N])}}}function l3(i,t){function e(){let O=!1,rt=new We,nt=null,Et=new We(0,0,0,0);return{setMask:function(xt){nt!==xt&&!O&&(i.colorMask(xt,xt,xt,xt),nt=xt)},setLocked:function(xt){O=xt},setClear:function(xt,bt,Xt,Qt,ht){ht===!0&&(xt*=Qt,bt*=Qt,Xt*=Qt),rt.set(xt,bt,Xt,Qt),Et.equals(rt)===!1&&(i.clearColor(xt,bt,Xt,Qt),Et.copy(rt))},reset:function(){O=!1,nt=null,Et.set(-1,0,0,0)}}}function n(){let O=!1,rt=!1,nt=null,Et=null,xt=null;return{setReversed:function(bt){if(rt!==bt){let Xt=t.get("EXT_clip_control");bt?Xt.clipControlEXT(Xt.LOWER_LEFT_EXT,Xt.ZERO_TO_ONE_EXT):Xt.clipControlEXT(Xt.LOWER_LEFT_EXT,Xt.NEGATIVE_ONE_TO_ONE_EXT),rt=bt;let Qt=xt;xt=null,this.setClear(Qt)}},getReversed:function(){return rt},setTest:function(bt){bt?Mt(i.DEPTH_TEST):qt(i.DEPTH_TEST)},setMask:function(bt){nt!==bt&&!O&&(i.depthMask(bt),nt=bt)},setFunc:function(bt){if(rt&&(bt=cy[bt]),Et!==bt){switch(bt){case Eh:i.depthFunc(i.NEVER);break;case zo:i.depthFunc(i.ALWAYS);break;case Th:i.depthFunc(i.LESS);break;case Ho:i.depthFunc(i.LEQUAL);break;case Ah:i.depthFunc(i.EQUAL);break;case Rh:i.depthFunc(i.GEQUAL);break;case Ch:i.depthFunc(i.GREATER);break;case Ih:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Et=bt}},setLocked:function(bt){O=bt},setClear:function(bt){xt!==bt&&(xt=bt,rt&&(bt=1-bt),i.clearDepth(bt))},reset:function(){O=!1,nt=null,Et=null,xt=null,rt=!1}}}function s(){let O=!1,rt=null,nt=null,Et=null,xt=null,bt=null,Xt=null,Qt=null,ht=null;return{setTest:function(Bt){O||(Bt?Mt(i.STENCIL_TEST):qt(i.STENCIL_TEST))},setMask:function(Bt){rt!==Bt&&!O&&(i.stencilMask(Bt),rt=Bt)},setFunc:function(Bt,te,Ct){(nt!==Bt||Et!==te||xt!==Ct)&&(i.stencilFunc(Bt,te,Ct),nt=Bt,Et=te,xt=Ct)},setOp:function(Bt,te,Ct){(bt!==Bt||Xt!==te||Qt!==Ct)&&(i.stencilOp(Bt,te,Ct),bt=Bt,Xt=te,Qt=Ct)},setLocked:function(Bt){O=Bt},setClear:function(Bt){ht!==Bt&&(i.clearStencil(Bt),ht=Bt)},reset:function(){O=!1,rt=null,nt=null,Et=null,xt=null,bt=null,Xt=null,Qt=null,ht=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],x=null,g=!1,m=null,v=null,M=null,w=null,R=null,T=null,y=null,A=new we(0,0,0),U=0,N=!1,P=null,G=null,W=null,D=null,V=null,$=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),k=!1,ot=0,K=i.getParameter(i.VERSION);K.indexOf("WebGL")!==-1?(ot=parseFloat(/^WebGL (\d)/.exec(K)[1]),k=ot>=1):K.indexOf("OpenGL ES")!==-1&&(ot=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),k=ot>=2);let Q=null,st={},ft=i.getParameter(i.SCISSOR_BOX),dt=i.getParameter(i.VIEWPORT),tt=new We().fromArray(ft),gt=new We().fromArray(dt);function yt(O,rt,nt,Et){let xt=new Uint8Array(4),bt=i.createTexture();i.bindTexture(O,bt),i.texParameteri(O,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(O,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Xt=0;Xt<nt;Xt++)O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY?i.texImage3D(rt,0,i.RGBA,1,1,Et,0,i.RGBA,i.UNSIGNED_BYTE,xt):i.texImage2D(rt+Xt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,xt);return bt}let Rt={};Rt[i.TEXTURE_2D]=yt(i.TEXTURE_2D,i.TEXTURE_2D,1),Rt[i.TEXTURE_CUBE_MAP]=yt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Rt[i.TEXTURE_2D_ARRAY]=yt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Rt[i.TEXTURE_3D]=yt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Mt(i.DEPTH_TEST),o.setFunc(Ho),mn(!1),Oe(yp),Mt(i.CULL_FACE),Je(Rs);function Mt(O){h[O]!==!0&&(i.enable(O),h[O]=!0)}function qt(O){h[O]!==!1&&(i.disable(O),h[O]=!1)}function oe(O,rt){return d[O]!==rt?(i.bindFramebuffer(O,rt),d[O]=rt,O===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=rt),O===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=rt),!0):!1}function Wt(O,rt){let nt=p,Et=!1;if(O){nt=f.get(rt),nt===void 0&&(nt=[],f.set(rt,nt));let xt=O.textures;if(nt.length!==xt.length||nt[0]!==i.COLOR_ATTACHMENT0){for(let bt=0,Xt=xt.length;bt<Xt;bt++)nt[bt]=i.COLOR_ATTACHMENT0+bt;nt.length=xt.length,Et=!0}}else nt[0]!==i.BACK&&(nt[0]=i.BACK,Et=!0);Et&&i.drawBuffers(nt)}function fe(O){return x!==O?(i.useProgram(O),x=O,!0):!1}let he={[kr]:i.FUNC_ADD,[Nv]:i.FUNC_SUBTRACT,[Dv]:i.FUNC_REVERSE_SUBTRACT};he[nu]=i.MIN,he[Ov]=i.MAX;let se={[Fv]:i.ZERO,[il]:i.ONE,[Uv]:i.SRC_COLOR,[Mp]:i.SRC_ALPHA,[Gv]:i.SRC_ALPHA_SATURATE,[Hv]:i.DST_COLOR,[Bv]:i.DST_ALPHA,[kv]:i.ONE_MINUS_SRC_COLOR,[Sp]:i.ONE_MINUS_SRC_ALPHA,[Vv]:i.ONE_MINUS_DST_COLOR,[zv]:i.ONE_MINUS_DST_ALPHA,[Wv]:i.CONSTANT_COLOR,[$v]:i.ONE_MINUS_CONSTANT_COLOR,[Xv]:i.CONSTANT_ALPHA,[qv]:i.ONE_MINUS_CONSTANT_ALPHA};function Je(O,rt,nt,Et,xt,bt,Xt,Qt,ht,Bt){if(O===Rs){g===!0&&(qt(i.BLEND),g=!1);return}if(g===!1&&(Mt(i.BLEND),g=!0),O!==eu){if(O!==m||Bt!==N){if((v!==kr||R!==kr)&&(i.blendEquation(i.FUNC_ADD),v=kr,R=kr),Bt)switch(O){case Ko:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case _p:i.blendFunc(i.ONE,i.ONE);break;case wp:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case bp:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ne("WebGLState: Invalid blending: ",O);break}else switch(O){case Ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case _p:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case wp:ne("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case bp:ne("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ne("WebGLState: Invalid blending: ",O);break}M=null,w=null,T=null,y=null,A.set(0,0,0),U=0,m=O,N=Bt}return}xt=xt||rt,bt=bt||nt,Xt=Xt||Et,(rt!==v||xt!==R)&&(i.blendEquationSeparate(he[rt],he[xt]),v=rt,R=xt),(nt!==M||Et!==w||bt!==T||Xt!==y)&&(i.blendFuncSeparate(se[nt],se[Et],se[bt],se[Xt]),M=nt,w=Et,T=bt,y=Xt),(Qt.equals(A)===!1||ht!==U)&&(i.blendColor(Qt.r,Qt.g,Qt.b,ht),A.copy(Qt),U=ht),m=O,N=!1}function Ve(O,rt){O.side===Ri?qt(i.CULL_FACE):Mt(i.CULL_FACE);let nt=O.side===ei;rt&&(nt=!nt),mn(nt),O.blending===Ko&&O.transparent===!1?Je(Rs):Je(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Et=O.stencilWrite;a.setTest(Et),Et&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),Se(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?Mt(i.SAMPLE_ALPHA_TO_COVERAGE):qt(i.SAMPLE_ALPHA_TO_COVERAGE)}function mn(O){P!==O&&(O?i.frontFace(i.CW):i.frontFace(i.CCW),P=O)}function Oe(O){O!==Iv?(Mt(i.CULL_FACE),O!==G&&(O===yp?i.cullFace(i.BACK):O===Pv?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):qt(i.CULL_FACE),G=O}function Ln(O){O!==W&&(k&&i.lineWidth(O),W=O)}function Se(O,rt,nt){O?(Mt(i.POLYGON_OFFSET_FILL),(D!==rt||V!==nt)&&(D=rt,V=nt,o.getReversed()&&(rt=-rt,nt=-nt),i.polygonOffset(rt,nt))):qt(i.POLYGON_OFFSET_FILL)}function Sn(O){O?Mt(i.SCISSOR_TEST):qt(i.SCISSOR_TEST)}function on(O){O===void 0&&(O=i.TEXTURE0+$-1),Q!==O&&(i.activeTexture(O),Q=O)}function gn(O,rt,nt){nt===void 0&&(Q===null?nt=i.TEXTURE0+$-1:nt=Q);let Et=st[nt];Et===void 0&&(Et={type:void 0,texture:void 0},st[nt]=Et),(Et.type!==O||Et.texture!==rt)&&(Q!==nt&&(i.activeTexture(nt),Q=nt),i.bindTexture(O,rt||Rt[O]),Et.type=O,Et.texture=rt)}function F(){let O=st[Q];O!==void 0&&O.type!==void 0&&(i.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function It(){try{i.compressedTexImage2D(...arguments)}catch(O){ne("WebGLState:",O)}}function Zt(){try{i.compressedTexImage3D(...arguments)}catch(O){ne("WebGLState:",O)}}function ae(){try{i.texSubImage2D(...arguments)}catch(O){ne("WebGLState:",O)}}function St(){try{i.texSubImage3D(...arguments)}catch(O){ne("WebGLState:",O)}}function ke(){try{i.compressedTexSubImage2D(...arguments)}catch(O){ne("WebGLState:",O)}}function Gt(){try{i.compressedTexSubImage3D(...arguments)}catch(O){ne("WebGLState:",O)}}function Kt(){try{i.texStorage2D(...arguments)}catch(O){ne("WebGLState:",O)}}function C(){try{i.texStorage3D(...arguments)}catch(O){ne("WebGLState:",O)}}function b(){try{i.texImage2D(...arguments)}catch(O){ne("WebGLState:",O)}}function X(){try{i.texImage3D(...arguments)}catch(O){ne("WebGLState:",O)}}function ut(O){return u[O]!==void 0?u[O]:i.getParameter(O)}function at(O,rt){u[O]!==rt&&(i.pixelStorei(O,rt),u[O]=rt)}function vt(O){tt.equals(O)===!1&&(i.scissor(O.x,O.y,O.z,O.w),tt.copy(O))}function _t(O){gt.equals(O)===!1&&(i.viewport(O.x,O.y,O.z,O.w),gt.copy(O))}function et(O,rt){let nt=c.get(rt);nt===void 0&&(nt=new WeakMap,c.set(rt,nt));let Et=nt.get(O);Et===void 0&&(Et=i.getUniformBlockIndex(rt,O.name),i.uniformBlockBinding(rt,Et,Et),nt.set(O,Et))}function it(O,rt,nt){let xt=c.get(rt).get(O);l[xt]!==nt&&(i.bindBufferBase(i.UNIFORM_BUFFER,xt,nt),l[xt]=nt)}function mt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,st={},d={},l={},f=new WeakMap,p=[],x=null,g=!1,m=null,v=null,M=null,w=null,R=null,T=null,y=null,A=new we(0,0,0),U=0,N=!1,P=null,G=null,W=null,D=null,V=null,tt.set(0,0,i.canvas.width,i.canvas.height),gt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Mt,disable:qt,bindFramebuffer:oe,drawBuffers:Wt,useProgram:fe,setBlending:Je,setMaterial:Ve,setFlipSided:mn,setCullFace:Oe,setLineWidth:Ln,setPolygonOffset:Se,setScissorTest:Sn,activeTexture:on,bindTexture:gn,unbindTexture:F,compressedTexImage2D:It,compressedTexImage3D:Zt,texImage2D:b,texImage3D:X,pixelStorei:at,getParameter:ut,updateUBOMapping:et,uniformBlockBinding:it,texStorage2D:Kt,texStorage3D:C,texSubImage2D:ae,texSubImage3D:St,compressedTexSubImage2D:ke,compressedTexSubImage3D:Gt,scissor:vt,viewport:_t,reset:mt}}function c3(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new xe,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(C=>p.delete(C)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(C,b){return g?new OffscreenCanvas(C,b):$a("canvas")}function v(C,b,X){let ut=1,at=Kt(C);if((at.width>X||at.height>X)&&(ut=X/Math.max(at.width,at.height)),ut<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let vt=Math.floor(ut*at.width),_t=Math.floor(ut*at.height);d===void 0&&(d=m(vt,_t));let et=b?m(vt,_t):d;return et.width=vt,et.height=_t,et.getContext("2d").drawImage(C,0,0,vt,_t),jt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+vt+"x"+_t+")."),et}else return"data"in C&&jt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),C;return C}function M(C){return C.generateMipmaps}function w(C){i.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(C,b,X,ut,at,vt=!1){if(C!==null){if(i[C]!==void 0)return i[C];jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let _t;ut&&(_t=t.get("EXT_texture_norm16"),_t||jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=b;if(b===i.RED&&(X===i.FLOAT&&(et=i.R32F),X===i.HALF_FLOAT&&(et=i.R16F),X===i.UNSIGNED_BYTE&&(et=i.R8),X===i.UNSIGNED_SHORT&&_t&&(et=_t.R16_EXT),X===i.SHORT&&_t&&(et=_t.R16_SNORM_EXT)),b===i.RED_INTEGER&&(X===i.UNSIGNED_BYTE&&(et=i.R8UI),X===i.UNSIGNED_SHORT&&(et=i.R16UI),X===i.UNSIGNED_INT&&(et=i.R32UI),X===i.BYTE&&(et=i.R8I),X===i.SHORT&&(et=i.R16I),X===i.INT&&(et=i.R32I)),b===i.RG&&(X===i.FLOAT&&(et=i.RG32F),X===i.HALF_FLOAT&&(et=i.RG16F),X===i.UNSIGNED_BYTE&&(et=i.RG8),X===i.UNSIGNED_SHORT&&_t&&(et=_t.RG16_EXT),X===i.SHORT&&_t&&(et=_t.RG16_SNORM_EXT)),b===i.RG_INTEGER&&(X===i.UNSIGNED_BYTE&&(et=i.RG8UI),X===i.UNSIGNED_SHORT&&(et=i.RG16UI),X===i.UNSIGNED_INT&&(et=i.RG32UI),X===i.BYTE&&(et=i.RG8I),X===i.SHORT&&(et=i.RG16I),X===i.INT&&(et=i.RG32I)),b===i.RGB_INTEGER&&(X===i.UNSIGNED_BYTE&&(et=i.RGB8UI),X===i.UNSIGNED_SHORT&&(et=i.RGB16UI),X===i.UNSIGNED_INT&&(et=i.RGB32UI),X===i.BYTE&&(et=i.RGB8I),X===i.SHORT&&(et=i.RGB16I),X===i.INT&&(et=i.RGB32I)),b===i.RGBA_INTEGER&&(X===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),X===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),X===i.UNSIGNED_INT&&(et=i.RGBA32UI),X===i.BYTE&&(et=i.RGBA8I),X===i.SHORT&&(et=i.RGBA16I),X===i.INT&&(et=i.RGBA32I)),b===i.RGB&&(X===i.UNSIGNED_SHORT&&_t&&(et=_t.RGB16_EXT),X===i.SHORT&&_t&&(et=_t.RGB16_SNORM_EXT),X===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),X===i.UNSIGNED_INT_10F_11F_11F_REV&&(et=i.R11F_G11F_B10F)),b===i.RGBA){let it=vt?Ga:_e.getTransfer(at);X===i.FLOAT&&(et=i.RGBA32F),X===i.HALF_FLOAT&&(et=i.RGBA16F),X===i.UNSIGNED_BYTE&&(et=it===Pe?i.SRGB8_ALPHA8:i.RGBA8),X===i.UNSIGNED_SHORT&&_t&&(et=_t.RGBA16_EXT),X===i.SHORT&&_t&&(et=_t.RGBA16_SNORM_EXT),X===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),X===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function y(C,b){let X;return C?b===null||b===vi||b===zr?X=i.DEPTH24_STENCIL8:b===Hn?X=i.DEPTH32F_STENCIL8:b===Jo&&(X=i.DEPTH24_STENCIL8,jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===vi||b===zr?X=i.DEPTH_COMPONENT24:b===Hn?X=i.DEPTH_COMPONENT32F:b===Jo&&(X=i.DEPTH_COMPONENT16),X}function A(C,b){return M(C)===!0||C.isFramebufferTexture&&C.minFilter!==rn&&C.minFilter!==kn?Math.log2(Math.max(b.width,b.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?b.mipmaps.length:1}function U(C){let b=new WeakRef(C);n.get(C).__ref=b,p.add(b),x.register(C,b,b)}function N(C){let b=n.get(C).__ref;b!==void 0&&(p.delete(b),x.unregister(b))}function P(C){W(C.target)}function G(C){D(C.target)}function W(C){C.removeEventListener("dispose",P),N(C),$(C),C.isVideoTexture&&h.delete(C),C.isHTMLTexture&&u.delete(C)}function D(C){C.removeEventListener("dispose",G),N(C),ot(C)}function V(){for(let C of p){let b=C.deref();b!==void 0&&(b.isRenderTarget===!0?D(b):W(b))}p.clear(),u.clear()}function $(C){let b=n.get(C);if(b.__webglInit===void 0)return;let X=C.source,ut=f.get(X);if(ut){let at=ut[b.__cacheKey];at.usedTimes--,at.usedTimes===0&&k(C),Object.keys(ut).length===0&&f.delete(X)}n.remove(C)}function k(C){let b=n.get(C);i.deleteTexture(b.__webglTexture);let X=C.source,ut=f.get(X);delete ut[b.__cacheKey],o.memory.textures--}function ot(C){let b=n.get(C);b.__depthDisposeCallback&&b.__depthDisposeCallback();let X=C.depthTexture;if(X&&X.renderTarget===C&&W(X),C.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(b.__webglFramebuffer[at]))for(let vt=0;vt<b.__webglFramebuffer[at].length;vt++)i.deleteFramebuffer(b.__webglFramebuffer[at][vt]);else i.deleteFramebuffer(b.__webglFramebuffer[at]);b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer[at])}else{if(Array.isArray(b.__webglFramebuffer))for(let at=0;at<b.__webglFramebuffer.length;at++)i.deleteFramebuffer(b.__webglFramebuffer[at]);else i.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&i.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let at=0;at<b.__webglColorRenderbuffer.length;at++)b.__webglColorRenderbuffer[at]&&i.deleteRenderbuffer(b.__webglColorRenderbuffer[at]);b.__webglDepthRenderbuffer&&i.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let ut=C.textures;for(let at=0,vt=ut.length;at<vt;at++){let _t=n.get(ut[at]);_t.__webglTexture&&(i.deleteTexture(_t.__webglTexture),o.memory.textures--),n.remove(ut[at])}n.remove(C)}let K=0;function Q(){K=0}function st(){return K}function ft(C){K=C}function dt(){let C=K;return C>=s.maxTextures&&jt("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,C}function tt(C){let b=[];return b.push(C.wrapS),b.push(C.wrapT),b.push(C.wrapR||0),b.push(C.magFilter),b.push(C.minFilter),b.push(C.anisotropy),b.push(C.internalFormat),b.push(C.format),b.push(C.type),b.push(C.generateMipmaps),b.push(C.mipmapsAutoUpdate),b.push(C.premultiplyAlpha),b.push(C.flipY),b.push(C.unpackAlignment),b.push(C.colorSpace),b.join()}function gt(C,b){let X=n.get(C);if(C.isVideoTexture&&ke(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&X.__version!==C.version){let ut=C.image;if(ut===null)jt("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)jt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ve(X,C,b);return}}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,X.__webglTexture,i.TEXTURE0+b)}function yt(C,b){let X=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){Ve(X,C,b);return}else C.isExternalTexture&&(X.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,X.__webglTexture,i.TEXTURE0+b)}function Rt(C,b){let X=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&X.__version!==C.version){Ve(X,C,b);return}e.bindTexture(i.TEXTURE_3D,X.__webglTexture,i.TEXTURE0+b)}function Mt(C,b){let X=n.get(C);if(C.version>0&&X.__version!==C.version){mn(X,C,b);return}e.bindTexture(i.TEXTURE_CUBE_MAP,X.__webglTexture,i.TEXTURE0+b)}let qt={[Ph]:i.REPEAT,[ss]:i.CLAMP_TO_EDGE,[Lh]:i.MIRRORED_REPEAT},oe={[rn]:i.NEAREST,[Zv]:i.NEAREST_MIPMAP_NEAREST,[sl]:i.NEAREST_MIPMAP_LINEAR,[kn]:i.LINEAR,[ru]:i.LINEAR_MIPMAP_NEAREST,[Cs]:i.LINEAR_MIPMAP_LINEAR},Wt={[ty]:i.NEVER,[Wp]:i.ALWAYS,[ey]:i.LESS,[Vp]:i.LEQUAL,[ny]:i.EQUAL,[Gp]:i.GEQUAL,[iy]:i.GREATER,[sy]:i.NOTEQUAL};function fe(C,b){if(b.type===Hn&&t.has("OES_texture_float_linear")===!1&&(b.magFilter===kn||b.magFilter===ru||b.magFilter===sl||b.magFilter===Cs||b.minFilter===kn||b.minFilter===ru||b.minFilter===sl||b.minFilter===Cs)&&jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,qt[b.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,qt[b.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,qt[b.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,oe[b.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,oe[b.minFilter]),b.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,Wt[b.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===rn||b.minFilter!==sl&&b.minFilter!==Cs||b.type===Hn&&t.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||n.get(b).__currentAnisotropy){let X=t.get("EXT_texture_filter_anisotropic");i.texParameterf(C,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),n.get(b).__currentAnisotropy=b.anisotropy}}}function he(C,b){let X=!1;C.__webglInit===void 0&&(C.__webglInit=!0,b.addEventListener("dispose",P),U(b));let ut=b.source,at=f.get(ut);at===void 0&&(at={},f.set(ut,at));let vt=tt(b);if(vt!==C.__cacheKey){at[vt]===void 0&&(at[vt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,X=!0),at[vt].usedTimes++;let _t=at[C.__cacheKey];_t!==void 0&&(at[C.__cacheKey].usedTimes--,_t.usedTimes===0&&k(b)),C.__cacheKey=vt,C.__webglTexture=at[vt].texture}return X}function se(C,b,X){return Math.floor(Math.floor(C/X)/b)}function Je(C,b,X,ut){let vt=C.updateRanges;if(vt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,b.width,b.height,X,ut,b.data);else{vt.sort((O,rt)=>O.start-rt.start);let _t=0;for(let O=1;O<vt.length;O++){let rt=vt[_t],nt=vt[O],Et=rt.start+rt.count,xt=se(nt.start,b.width,4),bt=se(rt.start,b.width,4);nt.start<=Et+1&&xt===bt&&se(nt.start+nt.count-1,b.width,4)===xt?rt.count=Math.max(rt.count,nt.start+nt.count-rt.start):(++_t,vt[_t]=nt)}vt.length=_t+1;let et=e.getParameter(i.UNPACK_ROW_LENGTH),it=e.getParameter(i.UNPACK_SKIP_PIXELS),mt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,b.width);for(let O=0,rt=vt.length;O<rt;O++){let nt=vt[O],Et=Math.floor(nt.start/4),xt=Math.ceil(nt.count/4),bt=Et%b.width,Xt=Math.floor(Et/b.width),Qt=xt,ht=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Xt),e.texSubImage2D(i.TEXTURE_2D,0,bt,Xt,Qt,ht,X,ut,b.data)}C.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,et),e.pixelStorei(i.UNPACK_SKIP_PIXELS,it),e.pixelStorei(i.UNPACK_SKIP_ROWS,mt)}}function Ve(C,b,X){let ut=i.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(ut=i.TEXTURE_2D_ARRAY),b.isData3DTexture&&(ut=i.TEXTURE_3D);let at=he(C,b),vt=b.source;e.bindTexture(ut,C.__webglTexture,i.TEXTURE0+X);let _t=n.get(vt);if(vt.version!==_t.__version||at===!0){if(e.activeTexture(i.TEXTURE0+X),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let ht=_e.getPrimaries(_e.workingColorSpace),Bt=b.colorSpace===Ps?null:_e.getPrimaries(b.colorSpace),te=b.colorSpace===Ps||ht===Bt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,te)}e.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment);let it=v(b.image,!1,s.maxTextureSize);it=Gt(b,it);let mt=r.convert(b.format,b.colorSpace),O=r.convert(b.type),rt=T(b.internalFormat,mt,O,b.normalized,b.colorSpace,b.isVideoTexture);fe(ut,b);let nt,Et=b.mipmaps,xt=b.isVideoTexture!==!0,bt=_t.__version===void 0||at===!0,Xt=vt.dataReady,Qt=A(b,it);if(b.isDepthTexture)rt=y(b.format===Is,b.type),bt&&(xt?e.texStorage2D(i.TEXTURE_2D,1,rt,it.width,it.height):e.texImage2D(i.TEXTURE_2D,0,rt,it.width,it.height,0,mt,O,null));else if(b.isDataTexture)if(Et.length>0){xt&&bt&&e.texStorage2D(i.TEXTURE_2D,Qt,rt,Et[0].width,Et[0].height);for(let ht=0,Bt=Et.length;ht<Bt;ht++)nt=Et[ht],xt?Xt&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,nt.width,nt.height,mt,O,nt.data):e.texImage2D(i.TEXTURE_2D,ht,rt,nt.width,nt.height,0,mt,O,nt.data);b.generateMipmaps=!1}else xt?(bt&&e.texStorage2D(i.TEXTURE_2D,Qt,rt,it.width,it.height),Xt&&Je(b,it,mt,O)):e.texImage2D(i.TEXTURE_2D,0,rt,it.width,it.height,0,mt,O,it.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){xt&&bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Qt,rt,Et[0].width,Et[0].height,it.depth);for(let ht=0,Bt=Et.length;ht<Bt;ht++)if(nt=Et[ht],b.format!==Vn)if(mt!==null)if(xt){if(Xt)if(b.layerUpdates.size>0){let te=Zp(nt.width,nt.height,b.format,b.type);for(let Ct of b.layerUpdates){let le=nt.data.subarray(Ct*te/nt.data.BYTES_PER_ELEMENT,(Ct+1)*te/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,Ct,nt.width,nt.height,1,mt,le)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,0,nt.width,nt.height,it.depth,mt,nt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ht,rt,nt.width,nt.height,it.depth,0,nt.data,0,0);else jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?Xt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ht,0,0,0,nt.width,nt.height,it.depth,mt,O,nt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ht,rt,nt.width,nt.height,it.depth,0,mt,O,nt.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{xt&&bt&&e.texStorage2D(i.TEXTURE_2D,Qt,rt,Et[0].width,Et[0].height);for(let ht=0,Bt=Et.length;ht<Bt;ht++)nt=Et[ht],b.format!==Vn?mt!==null?xt?Xt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ht,0,0,nt.width,nt.height,mt,nt.data):e.compressedTexImage2D(i.TEXTURE_2D,ht,rt,nt.width,nt.height,0,nt.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?Xt&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,nt.width,nt.height,mt,O,nt.data):e.texImage2D(i.TEXTURE_2D,ht,rt,nt.width,nt.height,0,mt,O,nt.data)}else if(b.isDataArrayTexture)if(xt){if(bt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Qt,rt,it.width,it.height,it.depth),Xt)if(b.layerUpdates.size>0){let ht=Zp(it.width,it.height,b.format,b.type);for(let Bt of b.layerUpdates){let te=it.data.subarray(Bt*ht/it.data.BYTES_PER_ELEMENT,(Bt+1)*ht/it.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Bt,it.width,it.height,1,mt,O,te)}b.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,it.width,it.height,it.depth,mt,O,it.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,rt,it.width,it.height,it.depth,0,mt,O,it.data);else if(b.isData3DTexture)xt?(bt&&e.texStorage3D(i.TEXTURE_3D,Qt,rt,it.width,it.height,it.depth),Xt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,it.width,it.height,it.depth,mt,O,it.data)):e.texImage3D(i.TEXTURE_3D,0,rt,it.width,it.height,it.depth,0,mt,O,it.data);else if(b.isFramebufferTexture){if(bt)if(xt)e.texStorage2D(i.TEXTURE_2D,Qt,rt,it.width,it.height);else{let ht=it.width,Bt=it.height;for(let te=0;te<Qt;te++)e.texImage2D(i.TEXTURE_2D,te,rt,ht,Bt,0,mt,O,null),ht>>=1,Bt>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in i){let ht=i.canvas;if(ht.hasAttribute("layoutsubtree")||ht.setAttribute("layoutsubtree","true"),it.parentNode!==ht){ht.appendChild(it),u.add(b),ht.onpaint=Bt=>{let te=Bt.changedElements;for(let Ct of u)te.includes(Ct.image)&&(Ct.needsUpdate=!0)},ht.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,it);else{let te=i.RGBA,Ct=i.RGBA,le=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,te,Ct,le,it)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Et.length>0){if(xt&&bt){let ht=Kt(Et[0]);e.texStorage2D(i.TEXTURE_2D,Qt,rt,ht.width,ht.height)}for(let ht=0,Bt=Et.length;ht<Bt;ht++)nt=Et[ht],xt?Xt&&e.texSubImage2D(i.TEXTURE_2D,ht,0,0,mt,O,nt):e.texImage2D(i.TEXTURE_2D,ht,rt,mt,O,nt);b.generateMipmaps=!1}else if(xt){if(bt){let ht=Kt(it);e.texStorage2D(i.TEXTURE_2D,Qt,rt,ht.width,ht.height)}Xt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,mt,O,it)}else e.texImage2D(i.TEXTURE_2D,0,rt,mt,O,it);M(b)&&b.mipmapsAutoUpdate===!0&&w(ut),_t.__version=vt.version,b.onUpdate&&b.onUpdate(b)}C.__version=b.version}function mn(C,b,X){if(b.image.length!==6)return;let ut=he(C,b),at=b.source;e.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+X);let vt=n.get(at);if(at.version!==vt.__version||ut===!0){e.activeTexture(i.TEXTURE0+X);let _t=_e.getPrimaries(_e.workingColorSpace),et=b.colorSpace===Ps?null:_e.getPrimaries(b.colorSpace),it=b.colorSpace===Ps||_t===et?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,it);let mt=b.isCompressedTexture||b.image[0].isCompressedTexture,O=b.image[0]&&b.image[0].isDataTexture,rt=[];for(let Ct=0;Ct<6;Ct++)!mt&&!O?rt[Ct]=v(b.image[Ct],!0,s.maxCubemapSize):rt[Ct]=O?b.image[Ct].image:b.image[Ct],rt[Ct]=Gt(b,rt[Ct]);let nt=rt[0],Et=r.convert(b.format,b.colorSpace),xt=r.convert(b.type),bt=T(b.internalFormat,Et,xt,b.normalized,b.colorSpace),Xt=b.isVideoTexture!==!0,Qt=vt.__version===void 0||ut===!0,ht=at.dataReady,Bt=A(b,nt);fe(i.TEXTURE_CUBE_MAP,b);let te;if(b.isDepthTexture){if(bt=y(b.format===Is,b.type),Qt)if(Xt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,bt,nt.width,nt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,nt.width,nt.height,0,Et,xt,null)}else if(mt){Xt&&Qt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Bt,bt,nt.width,nt.height);for(let Ct=0;Ct<6;Ct++){te=rt[Ct].mipmaps;for(let le=0;le<te.length;le++){let $e=te[le];b.format!==Vn?Et!==null?Xt?ht&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,0,0,$e.width,$e.height,Et,$e.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,bt,$e.width,$e.height,0,$e.data):jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,0,0,$e.width,$e.height,Et,xt,$e.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,bt,$e.width,$e.height,0,Et,xt,$e.data)}}}else{if(te=b.mipmaps,Xt&&Qt){te.length>0&&Bt++;let Ct=Kt(rt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Bt,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(O){Xt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,rt[Ct].width,rt[Ct].height,Et,xt,rt[Ct].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,rt[Ct].width,rt[Ct].height,0,Et,xt,rt[Ct].data);for(let le=0;le<te.length;le++){let Yn=te[le].image[Ct].image;Xt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,0,0,Yn.width,Yn.height,Et,xt,Yn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,bt,Yn.width,Yn.height,0,Et,xt,Yn.data)}}else{Xt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Et,xt,rt[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,Et,xt,rt[Ct]);for(let le=0;le<te.length;le++){let $e=te[le];Xt?ht&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,0,0,Et,xt,$e.image[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,bt,Et,xt,$e.image[Ct])}}}M(b)&&b.mipmapsAutoUpdate===!0&&w(i.TEXTURE_CUBE_MAP),vt.__version=at.version,b.onUpdate&&b.onUpdate(b)}C.__version=b.version}function Oe(C,b,X,ut,at,vt){let _t=r.convert(X.format,X.colorSpace),et=r.convert(X.type),it=T(X.internalFormat,_t,et,X.normalized,X.colorSpace),mt=n.get(b),O=n.get(X);if(O.__renderTarget=b,!mt.__hasExternalTextures){let rt=Math.max(1,b.width>>vt),nt=Math.max(1,b.height>>vt);at===i.TEXTURE_3D||at===i.TEXTURE_2D_ARRAY?e.texImage3D(at,vt,it,rt,nt,b.depth,0,_t,et,null):e.texImage2D(at,vt,it,rt,nt,0,_t,et,null)}e.bindFramebuffer(i.FRAMEBUFFER,C),St(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ut,at,O.__webglTexture,0,ae(b)):(at===i.TEXTURE_2D||at>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ut,at,O.__webglTexture,vt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ln(C,b,X){if(i.bindRenderbuffer(i.RENDERBUFFER,C),b.depthBuffer){let ut=b.depthTexture,at=ut&&ut.isDepthTexture?ut.type:null,vt=y(b.stencilBuffer,at),_t=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;St(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ae(b),vt,b.width,b.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,ae(b),vt,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,vt,b.width,b.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,_t,i.RENDERBUFFER,C)}else{let ut=b.textures;for(let at=0;at<ut.length;at++){let vt=ut[at],_t=r.convert(vt.format,vt.colorSpace),et=r.convert(vt.type),it=T(vt.internalFormat,_t,et,vt.normalized,vt.colorSpace);St(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ae(b),it,b.width,b.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,ae(b),it,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,it,b.width,b.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Se(C,b,X){let ut=b.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,C),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=n.get(b.depthTexture);at.__renderTarget=b;let vt=ut?b.depthTexture.image[0]:b.depthTexture.image;(!at.__webglTexture||vt.width!==b.width||vt.height!==b.height)&&(vt.width=b.width,vt.height=b.height,b.depthTexture.needsUpdate=!0),ut?Mt(b.depthTexture,0):gt(b.depthTexture,0);let _t=at.__webglTexture,et=ae(b),it=ut?i.TEXTURE_CUBE_MAP_POSITIVE_X+X:i.TEXTURE_2D,mt=b.depthTexture.format===Is?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(b.depthTexture.format===Ts)St(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,it,_t,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,mt,it,_t,0);else if(b.depthTexture.format===Is)St(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,it,_t,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,mt,it,_t,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Sn(C){let b=n.get(C),X=C.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==C.depthTexture){let ut=C.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),ut){let at=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,ut.removeEventListener("dispose",at)};ut.addEventListener("dispose",at),b.__depthDisposeCallback=at}b.__boundDepthTexture=ut}if(C.depthTexture&&!b.__autoAllocateDepthBuffer)if(X)for(let ut=0;ut<6;ut++)Se(b.__webglFramebuffer[ut],C,ut);else C.texture.mipmaps.length>0?Se(b.__webglFramebuffer[0],C,0):Se(b.__webglFramebuffer,C,0);else if(X){b.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[ut]),b.__webglDepthbuffer[ut]===void 0)b.__webglDepthbuffer[ut]=i.createRenderbuffer(),Ln(b.__webglDepthbuffer[ut],C,!1);else{let at=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,vt=b.__webglDepthbuffer[ut];i.bindRenderbuffer(i.RENDERBUFFER,vt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,vt)}}else if(C.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=i.createRenderbuffer(),Ln(b.__webglDepthbuffer,C,!1);else{let at=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,vt=b.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,vt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,vt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function on(C,b,X){let ut=n.get(C);b!==void 0&&Oe(ut.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),X!==void 0&&Sn(C)}function gn(C){let b=C.texture,X=n.get(C),ut=n.get(b);C.addEventListener("dispose",G),U(C);let at=C.textures,vt=C.isWebGLCubeRenderTarget===!0,_t=at.length>1;if(_t||(ut.__webglTexture===void 0&&(ut.__webglTexture=i.createTexture()),ut.__version=b.version,o.memory.textures++),vt){X.__webglFramebuffer=[];for(let et=0;et<6;et++)if(b.mipmaps.length>0){X.__webglFramebuffer[et]=[];for(let it=0;it<b.mipmaps.length;it++)X.__webglFramebuffer[et][it]=i.createFramebuffer()}else X.__webglFramebuffer[et]=i.createFramebuffer()}else{if(b.mipmaps.length>0){X.__webglFramebuffer=[];for(let et=0;et<b.mipmaps.length;et++)X.__webglFramebuffer[et]=i.createFramebuffer()}else X.__webglFramebuffer=i.createFramebuffer();if(_t)for(let et=0,it=at.length;et<it;et++){let mt=n.get(at[et]);mt.__webglTexture===void 0&&(mt.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&St(C)===!1){X.__webglMultisampledFramebuffer=i.createFramebuffer(),X.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let et=0;et<at.length;et++){let it=at[et];X.__webglColorRenderbuffer[et]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,X.__webglColorRenderbuffer[et]);let mt=r.convert(it.format,it.colorSpace),O=r.convert(it.type),rt=T(it.internalFormat,mt,O,it.normalized,it.colorSpace,C.isXRRenderTarget===!0),nt=ae(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,nt,rt,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+et,i.RENDERBUFFER,X.__webglColorRenderbuffer[et])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(X.__webglDepthRenderbuffer=i.createRenderbuffer(),Ln(X.__webglDepthRenderbuffer,C,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(vt){e.bindTexture(i.TEXTURE_CUBE_MAP,ut.__webglTexture),fe(i.TEXTURE_CUBE_MAP,b);for(let et=0;et<6;et++)if(b.mipmaps.length>0)for(let it=0;it<b.mipmaps.length;it++)Oe(X.__webglFramebuffer[et][it],C,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,it);else Oe(X.__webglFramebuffer[et],C,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);M(b)?w(i.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}else if(_t){for(let et=0,it=at.length;et<it;et++){let mt=at[et],O=n.get(mt),rt=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(rt=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(rt,O.__webglTexture),fe(rt,mt),Oe(X.__webglFramebuffer,C,mt,i.COLOR_ATTACHMENT0+et,rt,0),M(mt)&&w(rt)}e.unbindTexture()}else{let et=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(et=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(et,ut.__webglTexture),fe(et,b),b.mipmaps.length>0)for(let it=0;it<b.mipmaps.length;it++)Oe(X.__webglFramebuffer[it],C,b,i.COLOR_ATTACHMENT0,et,it);else Oe(X.__webglFramebuffer,C,b,i.COLOR_ATTACHMENT0,et,0);M(b)?w(et):b.mipmaps.length>0&&i.texParameteri(et,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}C.depthBuffer&&Sn(C)}function F(C){let b=C.textures;for(let X=0,ut=b.length;X<ut;X++){let at=b[X];if(M(at)&&at.mipmapsAutoUpdate===!0){let vt=R(C),_t=n.get(at).__webglTexture;e.bindTexture(vt,_t),w(vt),e.unbindTexture()}}}let It=[];function Zt(C){if(C.samples>0){if(St(C)===!1){let b=C.textures,X=C.width,ut=C.height,at=i.COLOR_BUFFER_BIT,vt=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=n.get(C),et=b.length>1;if(et)for(let mt=0;mt<b.length;mt++)e.bindFramebuffer(i.FRAMEBUFFER,_t.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,_t.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,_t.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,_t.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,_t.__webglFramebuffer);for(let mt=0;mt<b.length;mt++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(at|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(at|=i.STENCIL_BUFFER_BIT)),et){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,_t.__webglColorRenderbuffer[mt]);let O=n.get(b[mt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,O,0)}i.blitFramebuffer(0,0,X,ut,0,0,X,ut,at,i.NEAREST),l===!0&&(It.length=0,It.push(i.COLOR_ATTACHMENT0+mt),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&It.push(vt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,It))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),et)for(let mt=0;mt<b.length;mt++){e.bindFramebuffer(i.FRAMEBUFFER,_t.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,_t.__webglColorRenderbuffer[mt]);let O=n.get(b[mt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,_t.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,O,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,_t.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let b=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[b])}}}function ae(C){return Math.min(s.maxSamples,C.samples)}function St(C){let b=n.get(C);return C.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function ke(C){let b=o.render.frame;h.get(C)!==b&&(h.set(C,b),C.update())}function Gt(C,b){let X=C.colorSpace,ut=C.format,at=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||X!==js&&X!==Ps&&(_e.getTransfer(X)===Pe?(ut!==Vn||at!==xi)&&jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ne("WebGLTextures: Unsupported texture color space:",X)),b}function Kt(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=dt,this.resetTextureUnits=Q,this.getTextureUnits=st,this.setTextureUnits=ft,this.setTexture2D=gt,this.setTexture2DArray=yt,this.setTexture3D=Rt,this.setTextureCube=Mt,this.rebindTextures=on,this.setupRenderTarget=gn,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=Zt,this.setupDepthRenderbuffer=Sn,this.setupFrameBufferTexture=Oe,this.useMultisampledRTT=St,this.dispose=V}function h3(i,t){function e(n,s=Ps){let r,o=_e.getTransfer(s);if(n===xi)return i.UNSIGNED_BYTE;if(n===au)return i.UNSIGNED_SHORT_4_4_4_4;if(n===lu)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Fp)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Up)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Dp)return i.BYTE;if(n===Op)return i.SHORT;if(n===Jo)return i.UNSIGNED_SHORT;if(n===ou)return i.INT;if(n===vi)return i.UNSIGNED_INT;if(n===Hn)return i.FLOAT;if(n===Wi)return i.HALF_FLOAT;if(n===kp)return i.ALPHA;if(n===Bp)return i.RGB;if(n===Vn)return i.RGBA;if(n===Ts)return i.DEPTH_COMPONENT;if(n===Is)return i.DEPTH_STENCIL;if(n===zp)return i.RED;if(n===cu)return i.RED_INTEGER;if(n===or)return i.RG;if(n===hu)return i.RG_INTEGER;if(n===jo)return i.RGBA_INTEGER;if(n===rl||n===ol||n===al||n===ll)if(o===Pe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===rl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ol)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===al)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ll)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===rl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ol)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===al)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ll)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===uu||n===du||n===fu||n===pu)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===uu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===du)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===fu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===pu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===mu||n===gu||n===xu||n===vu||n===yu||n===cl||n===_u)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===mu||n===gu)return o===Pe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===xu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===vu)return r.COMPRESSED_R11_EAC;if(n===yu)return r.COMPRESSED_SIGNED_R11_EAC;if(n===cl)return r.COMPRESSED_RG11_EAC;if(n===_u)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===wu||n===bu||n===Mu||n===Su||n===Eu||n===Tu||n===Au||n===Ru||n===Cu||n===Iu||n===Pu||n===Lu||n===Nu||n===Du)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===wu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===bu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Mu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Su)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Eu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Tu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Au)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ru)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Cu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Iu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Pu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Lu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Nu)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Du)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Ou||n===Fu||n===Uu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Ou)return o===Pe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Fu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Uu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===ku||n===Bu||n===hl||n===zu)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===ku)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Bu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===hl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===zu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===zr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var u3=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,d3=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,rm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new Qa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new ls({vertexShader:u3,fragmentShader:d3,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new nn(new tl(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},om=class extends rs{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",g=new rm,m={},v=e.getContextAttributes(),M=null,w=null,R=[],T=[],y=new xe,A=null,U=null,N=new pi;N.viewport=new We;let P=new pi;P.viewport=new We;let G=[N,P],W=new tu,D=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let gt=R[tt];return gt===void 0&&(gt=new Wo,R[tt]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(tt){let gt=R[tt];return gt===void 0&&(gt=new Wo,R[tt]=gt),gt.getGripSpace()},this.getHand=function(tt){let gt=R[tt];return gt===void 0&&(gt=new Wo,R[tt]=gt),gt.getHandSpace()};function $(tt){let gt=T.indexOf(tt.inputSource);if(gt===-1)return;let yt=R[gt];yt!==void 0&&(yt.update(tt.inputSource,tt.frame,c||o),yt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function k(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",k),s.removeEventListener("inputsourceschange",ot);for(let tt=0;tt<R.length;tt++){let gt=T[tt];gt!==null&&(T[tt]=null,R[tt].disconnect(gt))}D=null,V=null,g.reset();for(let tt in m)delete m[tt];if(t.setRenderTarget(M),f=null,d=null,u=null,s=null,w=null,dt.stop(),n.isPresenting=!1,t.setPixelRatio(A),t.setSize(y.width,y.height,!1),U!==null){let tt=U.camera;tt.fov=U.fov,tt.zoom=U.zoom,tt.updateProjectionMatrix(),U=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,n.isPresenting===!0&&jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,n.isPresenting===!0&&jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(M=t.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",k),s.addEventListener("inputsourceschange",ot),v.xrCompatible!==!0&&await e.makeXRCompatible(),A=t.getPixelRatio(),t.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let yt=null,Rt=null,Mt=null;v.depth&&(Mt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,yt=v.stencil?Is:Ts,Rt=v.stencil?zr:vi);let qt={colorFormat:e.RGBA8,depthFormat:Mt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(qt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),w=new zn(d.textureWidth,d.textureHeight,{format:Vn,type:xi,depthTexture:new As(d.textureWidth,d.textureHeight,Rt,void 0,void 0,void 0,void 0,void 0,void 0,yt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let yt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,yt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),w=new zn(f.framebufferWidth,f.framebufferHeight,{format:Vn,type:xi,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),dt.setContext(s),dt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ot(tt){for(let gt=0;gt<tt.removed.length;gt++){let yt=tt.removed[gt],Rt=T.indexOf(yt);Rt>=0&&(T[Rt]=null,R[Rt].disconnect(yt))}for(let gt=0;gt<tt.added.length;gt++){let yt=tt.added[gt],Rt=T.indexOf(yt);if(Rt===-1){for(let qt=0;qt<R.length;qt++)if(qt>=T.length){T.push(yt),Rt=qt;break}else if(T[qt]===null){T[qt]=yt,Rt=qt;break}if(Rt===-1)break}let Mt=R[Rt];Mt&&Mt.connect(yt)}}function K(tt,gt){gt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(gt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let gt=tt.near,yt=tt.far;g.texture!==null&&(g.depthNear>0&&(gt=g.depthNear),g.depthFar>0&&(yt=g.depthFar)),W.near=P.near=N.near=gt,W.far=P.far=N.far=yt,(D!==W.near||V!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),D=W.near,V=W.far),W.layers.mask=tt.layers.mask|6,N.layers.mask=W.layers.mask&-5,P.layers.mask=W.layers.mask&-3;let Rt=tt.parent,Mt=W.cameras;K(W,Rt);for(let qt=0;qt<Mt.length;qt++)K(Mt[qt],Rt);W.projectionMatrix.copy(N.projectionMatrix),W.projectionMatrixInverse.copy(N.projectionMatrixInverse),U===null&&tt.isPerspectiveCamera&&(U={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,W,Rt)};function Q(tt,gt,yt){yt===null?tt.matrix.copy(gt.matrixWorld):(tt.matrix.copy(yt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(gt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(gt.projectionMatrix),tt.projectionMatrixInverse.copy(gt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=Dh*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(tt){l=tt,d!==null&&(d.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(W)},this.getCameraTexture=function(tt){return m[tt]};let st=null;function ft(tt,gt){if(h=gt.getViewerPose(c||o),p=gt,h!==null){let yt=h.views;f!==null&&(t.setRenderTargetFramebuffer(w,f.framebuffer),t.setRenderTarget(w));let Rt=!1;yt.length!==W.cameras.length&&(W.cameras.length=0,Rt=!0);for(let Wt=0;Wt<yt.length;Wt++){let fe=yt[Wt],he=null;if(f!==null)he=f.getViewport(fe);else{let Je=u.getViewSubImage(d,fe);he=Je.viewport,Wt===0&&(t.setRenderTargetTextures(w,Je.colorTexture,Je.depthStencilTexture),t.setRenderTarget(w))}let se=G[Wt];se===void 0&&(se=new pi,se.layers.enable(Wt),se.viewport=new We,G[Wt]=se),se.matrix.fromArray(fe.transform.matrix),se.matrix.decompose(se.position,se.quaternion,se.scale),se.projectionMatrix.fromArray(fe.projectionMatrix),se.projectionMatrixInverse.copy(se.projectionMatrix).invert(),se.viewport.set(he.x,he.y,he.width,he.height),Wt===0&&(W.matrix.copy(se.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Rt===!0&&W.cameras.push(se)}let Mt=s.enabledFeatures;if(Mt&&Mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();let Wt=u.getDepthInformation(yt[0]);Wt&&Wt.isValid&&Wt.texture&&g.init(Wt,s.renderState)}if(Mt&&Mt.includes("camera-access")&&x){t.state.unbindTexture(),u=n.getBinding();for(let Wt=0;Wt<yt.length;Wt++){let fe=yt[Wt].camera;if(fe){let he=m[fe];he||(he=new Qa,m[fe]=he);let se=u.getCameraImage(fe);he.sourceTexture=se}}}}for(let yt=0;yt<R.length;yt++){let Rt=T[yt],Mt=R[yt];Rt!==null&&Mt!==void 0&&Mt.update(Rt,gt,c||o)}st&&st(tt,gt),gt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:gt}),p=null}let dt=new Fy;dt.setAnimationLoop(ft),this.setAnimationLoop=function(tt){st=tt},this.dispose=function(){}}},f3=new Ge,Xy=new ie;Xy.set(-1,0,0,0,1,0,0,0,1);function p3(i,t){function e(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,qp(i)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,v,M,w){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),u(g,m)):m.isMeshPhongMaterial?(r(g,m),h(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,w)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),x(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,v,M):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,e(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===ei&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,e(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===ei&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,e(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,e(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let v=t.get(m),M=v.envMap,w=v.envMapRotation;M&&(g.envMap.value=M,g.envMapRotation.value.setFromMatrix4(f3.makeRotationFromEuler(w)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Xy),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,v,M){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*v,g.scale.value=M*.5,m.map&&(g.map.value=m.map,e(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function h(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function u(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,v){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ei&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=v.texture,g.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function x(g,m){let v=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(v.matrixWorld),g.nearDistance.value=v.shadow.camera.near,g.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function m3(i,t,e,n){let s={},r={};function o(v,M){let w=M.program;n.uniformBlockBinding(v,w,s[v.id])}function a(v,M){let w=s[v.id];w===void 0&&(p(v),w=l(v),s[v.id]=w,v.addEventListener("dispose",g));let R=M.program;n.updateUBOMapping(v,R);let T=t.render.frame;r[v.id]!==T&&(c(v),r[v.id]=T)}function l(v){let M=i.createBuffer(),w=v.__size,R=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,w,R),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(v){let M=s[v.id],w=v.uniforms,R=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let T=0,y=w.length;T<y;T++){let A=w[T];if(Array.isArray(A))for(let U=0,N=A.length;U<N;U++)h(A[U],T,U,R);else h(A,T,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,M,w,R){if(d(v,M,w,R)===!0){let T=v.__offset,y=v.value;if(Array.isArray(y)){let A=0;for(let U=0;U<y.length;U++){let N=y[U],P=x(N,!0);u(N,v.__data,A),A+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,T,v.__data)}}function u(v,M,w){typeof v=="number"||typeof v=="boolean"?M[w]=v:v.isMatrix3?(M[w]=v.elements[0],M[w+1]=v.elements[1],M[w+2]=v.elements[2],M[w+3]=0,M[w+4]=v.elements[3],M[w+5]=v.elements[4],M[w+6]=v.elements[5],M[w+7]=0,M[w+8]=v.elements[6],M[w+9]=v.elements[7],M[w+10]=v.elements[8],M[w+11]=0):ArrayBuffer.isView(v)?M.set(v.subarray(0,M.length-w),w):v.toArray(M,w)}function d(v,M,w,R){let T=v.value,y=M+"_"+w;if(Array.isArray(T)){R[y]===void 0&&(R[y]=[]);let A=R[y],U=!1;for(let N=0;N<T.length;N++)f(T[N],A,N)===!0&&(U=!0);return U}return f(T,R,y)}function f(v,M,w){if(M[w]===void 0)return typeof v=="number"||typeof v=="boolean"?M[w]=v:ArrayBuffer.isView(v)?M[w]=v.slice():M[w]=v.clone(),!0;{let R=M[w];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return M[w]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function p(v){let M=v.uniforms,w=0,R=16;for(let y=0,A=M.length;y<A;y++){let U=Array.isArray(M[y])?M[y]:[M[y]];for(let N=0,P=U.length;N<P;N++){let G=U[N],W=Array.isArray(G.value)?G.value:[G.value],D=Array.isArray(M[y])||Array.isArray(G.value),V=w;for(let k=0,ot=W.length;k<ot;k++){let K=W[k],Q=x(K,D),st=w%R,ft=st%Q.boundary,dt=st+ft;w+=ft,dt!==0&&R-dt<Q.storage&&(w+=R-dt),k===0&&(V=w),w+=Q.storage}let $=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new $((w-V)/Float32Array.BYTES_PER_ELEMENT),G.__offset=V}}let T=w%R;return T>0&&(w+=R-T),v.__size=w,v.__cache={},this}function x(v,M){let w={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(w.boundary=4,w.storage=4):v.isVector2?(w.boundary=8,w.storage=8):v.isVector3||v.isColor?(w.boundary=16,w.storage=12):v.isVector4?(w.boundary=16,w.storage=16):v.isMatrix3?(w.boundary=16,w.storage=48):v.isMatrix4?(w.boundary=16,w.storage=64):v.isTexture?jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(w.boundary=16,w.storage=v.byteLength):jt("WebGLRenderer: Unsupported uniform value type.",v),M===!0&&(w.boundary=16,w.storage=Math.ceil(w.storage/16)*16),w}function g(v){let M=v.target;M.removeEventListener("dispose",g),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function m(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var g3=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),hs=null;function x3(){return hs===null&&(hs=new Gi(g3,16,16,or,Wi),hs.name="DFG_LUT",hs.minFilter=kn,hs.magFilter=kn,hs.wrapS=ss,hs.wrapT=ss,hs.generateMipmaps=!1,hs.needsUpdate=!0),hs}var Wu=class{constructor(t={}){let{canvas:e=oy(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=xi}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=f,g=new Set([jo,hu,cu]),m=new Set([xi,vi,Jo,zr,au,lu]),v=new Uint32Array(4),M=new Int32Array(4),w={textures:[],min:[],max:[],resolution:[]},R=null,T=null,y=[],A=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=cs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,P=!1,G=null,W=null,D=null,V=null;this._outputColorSpace=fi;let $=0,k=0,ot=null,K=-1,Q=null,st=new We,ft=new We,dt=null,tt=new we(0),gt=0,yt=e.width,Rt=e.height,Mt=1,qt=null,oe=null,Wt=new We(0,0,yt,Rt),fe=new We(0,0,yt,Rt),he=!1,se=new Or,Je=new Bh,Ve=!1,mn=!1,Oe=new Ge,Ln=new J,Se=new We,Sn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},on=!1;function gn(){return ot===null?Mt:1}let F=n;function It(E,B){return e.getContext(E,B)}let Zt,ae,St,ke,Gt,Kt,C,b,X,ut,at,vt,_t,et,it,mt,O,rt,nt,Et,xt,bt,Xt;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Bt,!1),e.addEventListener("webglcontextrestored",te,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),F===null){let B="webgl2";if(F=It(B,E),F===null)throw It(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qt()}catch(E){throw e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),ne("WebGLRenderer: "+E.message),E}function Qt(){Zt=new RC(F),Zt.init(),xt=new h3(F,Zt),ae=new xC(F,Zt,t,xt),St=new l3(F,Zt),ae.reversedDepthBuffer&&d&&St.buffers.depth.setReversed(!0),W=F.createFramebuffer(),D=F.createFramebuffer(),V=F.createFramebuffer(),ke=new PC(F),Gt=new Y2,Kt=new c3(F,Zt,St,Gt,ae,xt,ke),C=new AC(N),b=new NT(F),bt=new mC(F,b),X=new CC(F,b,ke,bt),ut=new NC(F,X,b,bt,ke),rt=new LC(F,ae,Kt),it=new vC(Gt),at=new q2(N,C,Zt,ae,bt,it),vt=new p3(N,Gt),_t=new Z2,et=new n3(Zt),O=new pC(N,C,St,ut,p,l),mt=new a3(N,ut,ae),Xt=new m3(F,ke,ae,St),nt=new gC(F,Zt,ke),Et=new IC(F,Zt,ke),ke.programs=at.programs,N.capabilities=ae,N.extensions=Zt,N.properties=Gt,N.renderLists=_t,N.shadowMap=mt,N.state=St,N.info=ke}x!==xi&&(U=new OC(x,e.width,e.height,a,s,r));let ht=new om(N,F);this.xr=ht,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let E=Zt.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Zt.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return Mt},this.setPixelRatio=function(E){E!==void 0&&(Mt=E,this.setSize(yt,Rt,!1))},this.getSize=function(E){return E.set(yt,Rt)},this.setSize=function(E,B,j=!0){if(ht.isPresenting){jt("WebGLRenderer: Can't change size while VR device is presenting.");return}yt=E,Rt=B,e.width=Math.floor(E*Mt),e.height=Math.floor(B*Mt),j===!0&&(e.style.width=E+"px",e.style.height=B+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,E,B)},this.getDrawingBufferSize=function(E){return E.set(yt*Mt,Rt*Mt).floor()},this.setDrawingBufferSize=function(E,B,j){yt=E,Rt=B,Mt=j,e.width=Math.floor(E*j),e.height=Math.floor(B*j),this.setViewport(0,0,E,B)},this.setEffects=function(E){if(x===xi){ne("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let B=0;B<E.length;B++)if(E[B].isOutputPass===!0){jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(st)},this.getViewport=function(E){return E.copy(Wt)},this.setViewport=function(E,B,j,q){E.isVector4?Wt.set(E.x,E.y,E.z,E.w):Wt.set(E,B,j,q),St.viewport(st.copy(Wt).multiplyScalar(gn()).round())},this.getScissor=function(E){return E.copy(fe)},this.setScissor=function(E,B,j,q){E.isVector4?fe.set(E.x,E.y,E.z,E.w):fe.set(E,B,j,q),St.scissor(ft.copy(fe).multiplyScalar(gn()).round())},this.getScissorTest=function(){return he},this.setScissorTest=function(E){St.setScissorTest(he=E)},this.setOpaqueSort=function(E){qt=E},this.setTransparentSort=function(E){oe=E},this.getClearColor=function(E){return E.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(E=!0,B=!0,j=!0){let q=0;if(E){let Y=!1;if(ot!==null){let Tt=ot.texture.format;Y=g.has(Tt)}if(Y){let Tt=ot.texture.type,Pt=m.has(Tt),At=O.getClearColor(),Lt=O.getClearAlpha(),Vt=At.r,ee=At.g,pe=At.b;Pt?(v[0]=Vt,v[1]=ee,v[2]=pe,v[3]=Lt,F.clearBufferuiv(F.COLOR,0,v)):(M[0]=Vt,M[1]=ee,M[2]=pe,M[3]=Lt,F.clearBufferiv(F.COLOR,0,M))}else q|=F.COLOR_BUFFER_BIT}B&&(q|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(q|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&F.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),G=E},this.dispose=function(){e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),O.dispose(),_t.dispose(),et.dispose(),Kt.dispose(),Gt.dispose(),C.dispose(),ut.dispose(),X.dispose(),bt.dispose(),Xt.dispose(),at.dispose(),ht.dispose(),ht.removeEventListener("sessionstart",yl),ht.removeEventListener("sessionend",Xi),fs.stop()};function Bt(E){E.preventDefault(),$p("WebGLRenderer: Context Lost."),P=!0}function te(){$p("WebGLRenderer: Context Restored."),P=!1;let E=ke.autoReset,B=mt.enabled,j=mt.autoUpdate,q=mt.needsUpdate,Y=mt.type;Qt(),ke.autoReset=E,mt.enabled=B,mt.autoUpdate=j,mt.needsUpdate=q,mt.type=Y}function Ct(E){ne("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function le(E){let B=E.target;B.removeEventListener("dispose",le),$e(B)}function $e(E){Yn(E),Gt.remove(E)}function Yn(E){let B=Gt.get(E).programs;B!==void 0&&(B.forEach(function(j){at.releaseProgram(j)}),E.isShaderMaterial&&at.releaseShaderCache(E))}this.renderBufferDirect=function(E,B,j,q,Y,Tt){B===null&&(B=Sn);let Pt=Y.isMesh&&Y.matrixWorld.determinantAffine()<0,At=oa(E,B,j,q,Y);St.setMaterial(q,Pt);let Lt=j.index,Vt=1;if(q.wireframe===!0){if(Lt=X.getWireframeAttribute(j),Lt===void 0)return;Vt=2}let ee=j.drawRange,pe=j.attributes.position,zt=ee.start*Vt,me=(ee.start+ee.count)*Vt;Tt!==null&&(zt=Math.max(zt,Tt.start*Vt),me=Math.min(me,(Tt.start+Tt.count)*Vt)),Lt!==null?(zt=Math.max(zt,0),me=Math.min(me,Lt.count)):pe!=null&&(zt=Math.max(zt,0),me=Math.min(me,pe.count));let sn=me-zt;if(sn<0||sn===1/0)return;bt.setup(Y,q,At,j,Lt);let Le,Ne=nt;if(Lt!==null&&(Le=b.get(Lt),Ne=Et,Ne.setIndex(Le)),Y.isMesh)q.wireframe===!0?(St.setLineWidth(q.wireframeLinewidth*gn()),Ne.setMode(F.LINES)):Ne.setMode(F.TRIANGLES);else if(Y.isLine){let En=q.linewidth;En===void 0&&(En=1),St.setLineWidth(En*gn()),Y.isLineSegments?Ne.setMode(F.LINES):Y.isLineLoop?Ne.setMode(F.LINE_LOOP):Ne.setMode(F.LINE_STRIP)}else Y.isPoints?Ne.setMode(F.POINTS):Y.isSprite&&Ne.setMode(F.TRIANGLES);if(Y.isBatchedMesh)if(Zt.get("WEBGL_multi_draw"))Ne.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount);else{let En=Y._multiDrawStarts,Ut=Y._multiDrawCounts,xn=Y._multiDrawCount,ve=Lt?b.get(Lt).bytesPerElement:1,ms=Gt.get(q).currentProgram.getUniforms();for(let vn=0;vn<xn;vn++)ms.setValue(F,"_gl_DrawID",vn),Ne.render(En[vn]/ve,Ut[vn])}else if(Y.isInstancedMesh)Ne.renderInstances(zt,sn,Y.count);else if(j.isInstancedBufferGeometry){let En=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ut=Math.min(j.instanceCount,En);Ne.renderInstances(zt,sn,Ut)}else Ne.render(zt,sn)};function ia(E,B,j,q){G!==null&&E.isNodeMaterial&&G.setObject(q,E),Ve===!0&&it.setState(E,j,!1),E.transparent===!0&&E.side===Ri&&E.forceSinglePass===!1?(E.side=ei,E.needsUpdate=!0,qi(E,B,q),E.side=rr,E.needsUpdate=!0,qi(E,B,q),E.side=Ri):qi(E,B,q)}this.compile=function(E,B,j=null){j===null&&(j=E),G!==null&&G.renderStart(E,B,j),T=et.get(j),T.init(B),A.push(T),j.traverseVisible(function(Y){Y.isLight&&Y.layers.test(B.layers)&&(T.pushLight(Y),Y.castShadow&&T.pushShadow(Y))}),E!==j&&E.traverseVisible(function(Y){Y.isLight&&Y.layers.test(B.layers)&&(T.pushLight(Y),Y.castShadow&&T.pushShadow(Y))}),T.setupLights(),G!==null&&G.updateLights(T.state.lightsArray),mn=this.localClippingEnabled,Ve=it.init(this.clippingPlanes,mn),Ve===!0&&it.setGlobalState(this.clippingPlanes,B),G!==null&&mt.render(T.state.shadowsArray,j,B);let q=new Set;return E.traverse(function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;let Tt=Y.material;if(Tt)if(Array.isArray(Tt))for(let Pt=0;Pt<Tt.length;Pt++){let At=Tt[Pt];ia(At,j,B,Y),q.add(At)}else ia(Tt,j,B,Y),q.add(Tt)}),T=A.pop(),G!==null&&G.renderEnd(),q},this.compileAsync=function(E,B,j=null){let q=this.compile(E,B,j);return new Promise(Y=>{function Tt(){if(q.forEach(function(Pt){let Lt=Gt.get(Pt).currentProgram;(Lt===void 0||Lt.isReady())&&q.delete(Pt)}),q.size===0){Y(E);return}setTimeout(Tt,10)}Zt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Gr=null;function cd(E){Gr&&Gr(E)}function yl(){fs.stop()}function Xi(){fs.start()}let fs=new Fy;fs.setAnimationLoop(cd),typeof self<"u"&&fs.setContext(self),this.setAnimationLoop=function(E){Gr=E,ht.setAnimationLoop(E),E===null?fs.stop():fs.start()},ht.addEventListener("sessionstart",yl),ht.addEventListener("sessionend",Xi),this.render=function(E,B){if(B!==void 0&&B.isCamera!==!0){ne("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;G!==null&&G.renderStart(E,B);let j=ht.enabled===!0&&ht.isPresenting===!0,q=U!==null&&(ot===null||j)&&U.begin(N,ot);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),ht.enabled===!0&&ht.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ht.cameraAutoUpdate===!0&&ht.updateCamera(B),B=ht.getCamera()),E.isScene===!0&&E.onBeforeRender(N,E,B,ot),T=et.get(E,A.length),T.init(B),T.state.textureUnits=Kt.getTextureUnits(),A.push(T),Oe.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?Je.setFromArrayCamera(B):se.setFromProjectionMatrix(Oe,Ti,B.reversedDepth),mn=this.localClippingEnabled,Ve=it.init(this.clippingPlanes,mn),R=_t.get(E,y.length),R.init(),y.push(R),this.info.render.frame++,ht.enabled===!0&&ht.isPresenting===!0){let Pt=N.xr.getDepthSensingMesh();Pt!==null&&ps(Pt,B,-1/0,N.sortObjects)}ps(E,B,0,N.sortObjects),R.finish(),G!==null&&G.updateLights(T.state.lightsArray),N.sortObjects===!0&&R.sort(qt,oe),on=ht.enabled===!1||ht.isPresenting===!1||ht.hasDepthSensing()===!1,on&&O.addToRenderList(R,E),this.info.autoReset===!0&&this.info.reset(),Ve===!0&&it.beginShadows();let Y=T.state.shadowsArray;if(mt.render(Y,E,B),Ve===!0&&it.endShadows(),(q&&U.hasRenderPass())===!1){let Pt=R.opaque,At=R.transmissive;if(T.setupLights(),B.isArrayCamera){let Lt=B.cameras;if(At.length>0)for(let Vt=0,ee=Lt.length;Vt<ee;Vt++){let pe=Lt[Vt];Ci(Pt,At,E,pe)}on&&O.render(E);for(let Vt=0,ee=Lt.length;Vt<ee;Vt++){let pe=Lt[Vt];sa(R,E,pe,pe.viewport)}}else At.length>0&&Ci(Pt,At,E,B),on&&O.render(E),sa(R,E,B)}ot!==null&&k===0&&(Kt.updateMultisampleRenderTarget(ot),Kt.updateRenderTargetMipmap(ot)),q&&U.end(N),E.isScene===!0&&E.onAfterRender(N,E,B),bt.resetDefaultState(),K=-1,Q=null,A.pop(),A.length>0?(T=A[A.length-1],Kt.setTextureUnits(T.state.textureUnits),Ve===!0&&it.setGlobalState(N.clippingPlanes,T.state.camera)):T=null,y.pop(),y.length>0?R=y[y.length-1]:R=null,G!==null&&G.renderEnd()};function ps(E,B,j,q){if(E.visible===!1)return;if(E.layers.test(B.layers)){if(E.isGroup)j=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(B);else if(E.isLight)T.pushLight(E),E.castShadow&&T.pushShadow(E);else if(E.isSprite){let Pt=B.isArrayCamera?Je:se;if(!E.frustumCulled||E.intersectsFrustum(Pt)){q&&Se.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Oe);let At=ut.update(E),Lt=E.material;Lt.visible&&R.push(E,At,Lt,j,Se.z,null,B)}}else if(E.isMesh||E.isLine||E.isPoints){let Pt=B.isArrayCamera?Je:se;if(!E.frustumCulled||E.intersectsFrustum(Pt)){let At=ut.update(E),Lt=E.material;if(q&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Se.copy(E.boundingSphere.center)):(At.boundingSphere===null&&At.computeBoundingSphere(),Se.copy(At.boundingSphere.center)),Se.applyMatrix4(E.matrixWorld).applyMatrix4(Oe)),Array.isArray(Lt)){let Vt=At.groups;for(let ee=0,pe=Vt.length;ee<pe;ee++){let zt=Vt[ee],me=Lt[zt.materialIndex];me&&me.visible&&R.push(E,At,me,j,Se.z,zt,B)}}else Lt.visible&&R.push(E,At,Lt,j,Se.z,null,B)}}}let Tt=E.children;for(let Pt=0,At=Tt.length;Pt<At;Pt++)ps(Tt[Pt],B,j,q)}function sa(E,B,j,q){let{opaque:Y,transmissive:Tt,transparent:Pt}=E;T.setupLightsView(j),Ve===!0&&it.setGlobalState(N.clippingPlanes,j),q&&St.viewport(st.copy(q)),Y.length>0&&an(Y,B,j),Tt.length>0&&an(Tt,B,j),Pt.length>0&&an(Pt,B,j),St.buffers.depth.setTest(!0),St.buffers.depth.setMask(!0),St.buffers.color.setMask(!0),St.setPolygonOffset(!1)}function Ci(E,B,j,q){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[q.id]===void 0){let zt=Zt.has("EXT_color_buffer_half_float")||Zt.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[q.id]=new zn(1,1,{generateMipmaps:!0,type:zt?Wi:xi,minFilter:Cs,samples:Math.max(4,ae.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:_e.workingColorSpace})}let Tt=T.state.transmissionRenderTarget[q.id],Pt=q.viewport||st;Tt.setSize(Pt.z*N.transmissionResolutionScale,Pt.w*N.transmissionResolutionScale);let At=N.getRenderTarget(),Lt=N.getActiveCubeFace(),Vt=N.getActiveMipmapLevel();N.setRenderTarget(Tt),N.getClearColor(tt),gt=N.getClearAlpha(),gt<1&&N.setClearColor(16777215,.5),N.clear(),on&&O.render(j);let ee=N.toneMapping;N.toneMapping=cs;let pe=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),T.setupLightsView(q),Ve===!0&&it.setGlobalState(N.clippingPlanes,q),an(E,j,q),Kt.updateMultisampleRenderTarget(Tt),Kt.updateRenderTargetMipmap(Tt),Zt.has("WEBGL_multisampled_render_to_texture")===!1){let zt=!1;for(let me=0,sn=B.length;me<sn;me++){let Le=B[me],{object:Ne,geometry:En,material:Ut,group:xn}=Le;if(Ut.side===Ri&&Ne.layers.test(q.layers)){let ve=Ut.side;Ut.side=ei,Ut.needsUpdate=!0,dn(Ne,j,q,En,Ut,xn),Ut.side=ve,Ut.needsUpdate=!0,zt=!0}}zt===!0&&(Kt.updateMultisampleRenderTarget(Tt),Kt.updateRenderTargetMipmap(Tt))}N.setRenderTarget(At,Lt,Vt),N.setClearColor(tt,gt),pe!==void 0&&(q.viewport=pe),N.toneMapping=ee}function an(E,B,j){let q=B.isScene===!0?B.overrideMaterial:null;for(let Y=0,Tt=E.length;Y<Tt;Y++){let Pt=E[Y],{object:At,geometry:Lt,group:Vt}=Pt,ee=Pt.material;ee.allowOverride===!0&&q!==null&&(ee=q),At.layers.test(j.layers)&&dn(At,B,j,Lt,ee,Vt)}}function dn(E,B,j,q,Y,Tt){G!==null&&Y.isNodeMaterial&&G.setObject(E,Y),E.onBeforeRender(N,B,j,q,Y,Tt),E.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),Y.onBeforeRender(N,B,j,q,E,Tt),Y.transparent===!0&&Y.side===Ri&&Y.forceSinglePass===!1?(Y.side=ei,Y.needsUpdate=!0,N.renderBufferDirect(j,B,q,Y,E,Tt),Y.side=rr,Y.needsUpdate=!0,N.renderBufferDirect(j,B,q,Y,E,Tt),Y.side=Ri):N.renderBufferDirect(j,B,q,Y,E,Tt),E.onAfterRender(N,B,j,q,Y,Tt)}function fn(E){let B=0;for(let j of E)j.texture!==null&&B++;return B}function qi(E,B,j){B.isScene!==!0&&(B=Sn);let q=Gt.get(E),Y=T.state.lights,Tt=T.state.shadowsArray,Pt=Y.state.version,At=at.getParameters(E,Y.state,Tt,B,j,T.state.lightProbeGridArray),Lt=at.getProgramCacheKey(At),Vt=q.programs;q.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?B.environment:null,q.fog=B.fog;let ee=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;q.envMap=C.get(E.envMap||q.environment,ee),q.envMapRotation=q.environment!==null&&E.envMap===null?B.environmentRotation:E.envMapRotation,Vt===void 0&&(E.addEventListener("dispose",le),Vt=new Map,q.programs=Vt,q.programVariants=new Map);let pe=Vt.get(Lt);if(pe!==void 0){if(q.currentProgram===pe&&q.lightsStateVersion===Pt)return ra(E,At),pe}else At.uniforms=at.getUniforms(E),G!==null&&E.isNodeMaterial&&G.build(E,j,At),E.onBeforeCompile(At,N),pe=at.acquireProgram(At,Lt),Vt.set(Lt,pe),q.uniforms=At.uniforms;let zt=q.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(zt.clippingPlanes=it.uniform),ra(E,At),q.needsLights=Ds(E),q.lightsStateVersion=Pt,q.needsLights&&(zt.ambientLightColor.value=Y.state.ambient,zt.lightProbe.value=Y.state.probe,zt.sunLights.value=Y.state.sun,zt.sunLightShadows.value=Y.state.sunShadow,zt.directionalLights.value=Y.state.directional,zt.directionalLightShadows.value=Y.state.directionalShadow,zt.spotLights.value=Y.state.spot,zt.spotLightShadows.value=Y.state.spotShadow,zt.rectAreaLights.value=Y.state.rectArea,zt.ltc_1.value=Y.state.rectAreaLTC1,zt.ltc_2.value=Y.state.rectAreaLTC2,zt.pointLights.value=Y.state.point,zt.pointLightShadows.value=Y.state.pointShadow,zt.hemisphereLights.value=Y.state.hemi,zt.sunShadowMatrix.value=Y.state.sunShadowMatrix,zt.sunShadowCascade.value=Y.state.sunShadowCascade,zt.directionalShadowMatrix.value=Y.state.directionalShadowMatrix,zt.spotLightMatrix.value=Y.state.spotLightMatrix,zt.spotLightMap.value=Y.state.spotLightMap,zt.pointShadowMatrix.value=Y.state.pointShadowMatrix),q.numLightProbeGrids=fn(T.state.lightProbeGridArray),q.currentProgram=pe,q.uniformsList=null,pe}function si(E,B,j,q,Y){let Tt=Gt.get(E),Pt=Tt.currentProgram.id+","+q+","+Y,At=Tt.programVariants.get(Pt);return At===void 0?(At=qi(E,B,j),Tt.programVariants.set(Pt,At)):(Tt.currentProgram=At,Tt.uniformsList=null,Tt.outputColorSpace=q,Tt.toneMapping=Y),At}function Ns(E){if(E.uniformsList===null){let B=E.currentProgram.getUniforms();E.uniformsList=Qo.seqWithValue(B.seq,E.uniforms)}return E.uniformsList}function ra(E,B){let j=Gt.get(E);j.outputColorSpace=B.outputColorSpace,j.batching=B.batching,j.batchingColor=B.batchingColor,j.instancing=B.instancing,j.instancingColor=B.instancingColor,j.instancingMorph=B.instancingMorph,j.skinning=B.skinning,j.morphTargets=B.morphTargets,j.morphNormals=B.morphNormals,j.morphColors=B.morphColors,j.morphTargetsCount=B.morphTargetsCount,j.numClippingPlanes=B.numClippingPlanes,j.numIntersection=B.numClipIntersection,j.vertexAlphas=B.vertexAlphas,j.vertexTangents=B.vertexTangents,j.toneMapping=B.toneMapping}function oa(E,B,j,q,Y){B.isScene!==!0&&(B=Sn),Kt.resetTextureUnits();let Tt=B.fog,Pt=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?B.environment:null,At=ot===null?N.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:_e.workingColorSpace,Lt=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,Vt=C.get(q.envMap||Pt,Lt),ee=q.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,pe=!!j.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),zt=!!j.morphAttributes.position,me=!!j.morphAttributes.normal,sn=!!j.morphAttributes.color,Le=cs;q.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(Le=N.toneMapping);let Ne=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,En=Ne!==void 0?Ne.length:0,Ut=Gt.get(q),xn=T.state.lights;if(Ve===!0&&(mn===!0||E!==Q)){let De=E===Q&&q.id===K;it.setState(q,E,De)}let ve=!1,ms=!1;q.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==xn.state.version||Y.isBatchedMesh&&Ut.batching===!1||!Y.isBatchedMesh&&Ut.batching===!0||Y.isBatchedMesh&&Ut.batchingColor===!0&&Y._colorsTexture===null||Y.isBatchedMesh&&Ut.batchingColor===!1&&Y._colorsTexture!==null||Y.isInstancedMesh&&Ut.instancing===!1||!Y.isInstancedMesh&&Ut.instancing===!0||Y.isSkinnedMesh&&Ut.skinning===!1||!Y.isSkinnedMesh&&Ut.skinning===!0||Y.isInstancedMesh&&Ut.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&Ut.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&Ut.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&Ut.instancingMorph===!1&&Y.morphTexture!==null||Ut.envMap!==Vt||q.fog===!0&&Ut.fog!==Tt||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==it.numPlanes||Ut.numIntersection!==it.numIntersection)||Ut.vertexAlphas!==ee||Ut.vertexTangents!==pe||Ut.morphTargets!==zt||Ut.morphNormals!==me||Ut.morphColors!==sn||Ut.morphTargetsCount!==En||Ut.numLightProbeGrids!==fn(T.state.lightProbeGridArray)?ve=!0:(Ut.outputColorSpace!==At||Ut.toneMapping!==Le)&&(ms=!0):(ve=!0,Ut.__version=q.version);let vn=Ut.currentProgram;(ve===!0||ms===!0)&&(vn=ms===!0?si(q,B,Y,At,Le):qi(q,B,Y),G&&q.isNodeMaterial&&G.onUpdateProgram(q,vn,Ut));let Xr=!1,Yi=!1,gs=!1,ue=vn.getUniforms(),ln=Ut.uniforms;if(St.useProgram(vn.program)&&(Xr=!0,Yi=!0,gs=!0),q.id!==K&&(K=q.id,Yi=!0),Xr||Q!==E){St.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ue.setValue(F,"projectionMatrix",E.projectionMatrix),ue.setValue(F,"viewMatrix",E.matrixWorldInverse);let yn=ue.map.cameraPosition;yn!==void 0&&yn.setValue(F,Ln.setFromMatrixPosition(E.matrixWorld)),ae.logarithmicDepthBuffer&&ue.setValue(F,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&ue.setValue(F,"isOrthographic",E.isOrthographicCamera===!0),Q!==E&&(Q=E,Yi=!0,gs=!0)}if(Ut.needsLights&&(xn.state.sunShadowMap.length>0&&ue.setValue(F,"sunShadowMap",xn.state.sunShadowMap,Kt),xn.state.directionalShadowMap.length>0&&ue.setValue(F,"directionalShadowMap",xn.state.directionalShadowMap,Kt),xn.state.spotShadowMap.length>0&&ue.setValue(F,"spotShadowMap",xn.state.spotShadowMap,Kt),xn.state.pointShadowMap.length>0&&ue.setValue(F,"pointShadowMap",xn.state.pointShadowMap,Kt)),Y.isSkinnedMesh){ue.setOptional(F,Y,"bindMatrix"),ue.setOptional(F,Y,"bindMatrixInverse");let De=Y.skeleton;De&&(De.boneTexture===null&&De.computeBoneTexture(),ue.setValue(F,"boneTexture",De.boneTexture,Kt))}Y.isBatchedMesh&&(ue.setOptional(F,Y,"batchingTexture"),ue.setValue(F,"batchingTexture",Y._matricesTexture,Kt),ue.setOptional(F,Y,"batchingIdTexture"),ue.setValue(F,"batchingIdTexture",Y._indirectTexture,Kt),ue.setOptional(F,Y,"batchingColorTexture"),Y._colorsTexture!==null&&ue.setValue(F,"batchingColorTexture",Y._colorsTexture,Kt));let Kn=j.morphAttributes;if((Kn.position!==void 0||Kn.normal!==void 0||Kn.color!==void 0)&&rt.update(Y,j,vn),(Yi||Ut.receiveShadow!==Y.receiveShadow)&&(Ut.receiveShadow=Y.receiveShadow,ue.setValue(F,"receiveShadow",Y.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&B.environment!==null&&(ln.envMapIntensity.value=B.environmentIntensity),ln.dfgLUT!==void 0&&(ln.dfgLUT.value=x3()),Yi){if(ue.setValue(F,"toneMappingExposure",N.toneMappingExposure),Ut.needsLights&&Wr(ln,gs),Tt&&q.fog===!0&&vt.refreshFogUniforms(ln,Tt),vt.refreshMaterialUniforms(ln,q,Mt,Rt,T.state.transmissionRenderTarget[E.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let De=w,yn=0;for(let Gn of T.state.lightProbeGridArray)Gn.texture!==null&&(De.textures[yn]=Gn.texture,De.min[yn]=Gn.boundingBox.min,De.max[yn]=Gn.boundingBox.max,De.resolution[yn]=Gn.resolution,yn++);for(let Gn in De)De[Gn].length=yn;ln.probesSH.value=De.textures,ln.probesMin.value=De.min,ln.probesMax.value=De.max,ln.probesResolution.value=De.resolution}Qo.upload(F,Ns(Ut),ln,Kt)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(Qo.upload(F,Ns(Ut),ln,Kt),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&ue.setValue(F,"center",Y.center),ue.setValue(F,"modelViewMatrix",Y.modelViewMatrix),ue.setValue(F,"normalMatrix",Y.normalMatrix),ue.setValue(F,"modelMatrix",Y.matrixWorld),q.uniformsGroups!==void 0){let De=q.uniformsGroups;for(let yn=0,Gn=De.length;yn<Gn;yn++){let _l=De[yn];Xt.update(_l,vn),Xt.bind(_l,vn)}}return vn}function Wr(E,B){E.ambientLightColor.needsUpdate=B,E.lightProbe.needsUpdate=B,E.sunLights.needsUpdate=B,E.sunLightShadows.needsUpdate=B,E.directionalLights.needsUpdate=B,E.directionalLightShadows.needsUpdate=B,E.pointLights.needsUpdate=B,E.pointLightShadows.needsUpdate=B,E.spotLights.needsUpdate=B,E.spotLightShadows.needsUpdate=B,E.rectAreaLights.needsUpdate=B,E.hemisphereLights.needsUpdate=B}function Ds(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return k},this.getRenderTarget=function(){return ot},this.setRenderTargetTextures=function(E,B,j){let q=Gt.get(E);q.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),Gt.get(E.texture).__webglTexture=B,Gt.get(E.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:j,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,B){let j=Gt.get(E);j.__webglFramebuffer=B,j.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(E,B=0,j=0){ot=E,$=B,k=j;let q=null,Y=!1,Tt=!1;if(E){let At=Gt.get(E);if(At.__useDefaultFramebuffer!==void 0){St.bindFramebuffer(F.FRAMEBUFFER,At.__webglFramebuffer),st.copy(E.viewport),ft.copy(E.scissor),dt=E.scissorTest,St.viewport(st),St.scissor(ft),St.setScissorTest(dt),K=-1;return}else if(At.__webglFramebuffer===void 0)Kt.setupRenderTarget(E);else if(At.__hasExternalTextures)Kt.rebindTextures(E,Gt.get(E.texture).__webglTexture,Gt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let ee=E.depthTexture;if(At.__boundDepthTexture!==ee){if(ee!==null&&Gt.has(ee)&&(E.width!==ee.image.width||E.height!==ee.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Kt.setupDepthRenderbuffer(E)}}let Lt=E.texture;(Lt.isData3DTexture||Lt.isDataArrayTexture||Lt.isCompressedArrayTexture)&&(Tt=!0);let Vt=Gt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Vt[B])?q=Vt[B][j]:q=Vt[B],Y=!0):E.samples>0&&Kt.useMultisampledRTT(E)===!1?q=Gt.get(E).__webglMultisampledFramebuffer:Array.isArray(Vt)?q=Vt[j]:q=Vt,st.copy(E.viewport),ft.copy(E.scissor),dt=E.scissorTest}else st.copy(Wt).multiplyScalar(Mt).floor(),ft.copy(fe).multiplyScalar(Mt).floor(),dt=he;if(j!==0&&(q=W),St.bindFramebuffer(F.FRAMEBUFFER,q)&&St.drawBuffers(E,q),St.viewport(st),St.scissor(ft),St.setScissorTest(dt),Y){let At=Gt.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+B,At.__webglTexture,j)}else if(Tt){let At=B;for(let Lt=0;Lt<E.textures.length;Lt++){let Vt=Gt.get(E.textures[Lt]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Lt,Vt.__webglTexture,j,At)}}else if(E!==null&&j!==0){let At=Gt.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,At.__webglTexture,j)}K=-1};function $r(E){let B=Gt.get(E);return(B.__readFormat!==E.format||B.__readType!==E.type)&&(B.__readFormat=E.format,B.__readType=E.type,B.__formatReadable=ae.textureFormatReadable(E.format),B.__typeReadable=ae.textureTypeReadable(E.type)),B}this.readRenderTargetPixels=function(E,B,j,q,Y,Tt,Pt,At=0){if(!(E&&E.isWebGLRenderTarget)){ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Lt=Gt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pt!==void 0&&(Lt=Lt[Pt],Array.isArray(Lt)&&(Lt=Lt[0])),Lt){St.bindFramebuffer(F.FRAMEBUFFER,Lt);try{let Vt=E.textures[At],ee=Vt.format,pe=Vt.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+At);let zt=$r(Vt);if(zt.__formatReadable===!1){ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(zt.__typeReadable===!1){ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=E.width-q&&j>=0&&j<=E.height-Y&&F.readPixels(B,j,q,Y,xt.convert(ee),xt.convert(pe),Tt)}finally{let Vt=ot!==null?Gt.get(ot).__webglFramebuffer:null;St.bindFramebuffer(F.FRAMEBUFFER,Vt)}}},this.readRenderTargetPixelsAsync=async function(E,B,j,q,Y,Tt,Pt,At=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Lt=Gt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pt!==void 0&&(Lt=Lt[Pt],Array.isArray(Lt)&&(Lt=Lt[0])),Lt)if(B>=0&&B<=E.width-q&&j>=0&&j<=E.height-Y){St.bindFramebuffer(F.FRAMEBUFFER,Lt);let Vt=E.textures[At],ee=Vt.format,pe=Vt.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+At);let zt=$r(Vt);if(zt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(zt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let me=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,me),F.bufferData(F.PIXEL_PACK_BUFFER,Tt.byteLength,F.STREAM_READ),F.readPixels(B,j,q,Y,xt.convert(ee),xt.convert(pe),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let sn=ot!==null?Gt.get(ot).__webglFramebuffer:null;St.bindFramebuffer(F.FRAMEBUFFER,sn);let Le=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await ly(F,Le,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,me),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Tt),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(me),F.deleteSync(Le),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,B=null,j=0){let q=Math.pow(2,-j),Y=Math.floor(E.image.width*q),Tt=Math.floor(E.image.height*q),Pt=B!==null?B.x:0,At=B!==null?B.y:0;Kt.setTexture2D(E,0),F.copyTexSubImage2D(F.TEXTURE_2D,j,0,0,Pt,At,Y,Tt),St.unbindTexture()},this.copyTextureToTexture=function(E,B,j=null,q=null,Y=0,Tt=0){let Pt,At,Lt,Vt,ee,pe,zt,me,sn,Le=E.isCompressedTexture?E.mipmaps[Tt]:E.image;if(j!==null)Pt=j.max.x-j.min.x,At=j.max.y-j.min.y,Lt=j.isBox3?j.max.z-j.min.z:1,Vt=j.min.x,ee=j.min.y,pe=j.isBox3?j.min.z:0;else{let ue=Math.pow(2,-Y);Pt=Math.floor(Le.width*ue),At=Math.floor(Le.height*ue),E.isDataArrayTexture?Lt=Le.depth:E.isData3DTexture?Lt=Math.floor(Le.depth*ue):Lt=1,Vt=0,ee=0,pe=0}q!==null?(zt=q.x,me=q.y,sn=q.z):(zt=0,me=0,sn=0);let Ne=xt.convert(B.format),En=xt.convert(B.type),Ut;B.isData3DTexture?(Kt.setTexture3D(B,0),Ut=F.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(Kt.setTexture2DArray(B,0),Ut=F.TEXTURE_2D_ARRAY):(Kt.setTexture2D(B,0),Ut=F.TEXTURE_2D),St.activeTexture(F.TEXTURE0),St.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,B.flipY),St.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),St.pixelStorei(F.UNPACK_ALIGNMENT,B.unpackAlignment);let xn=St.getParameter(F.UNPACK_ROW_LENGTH),ve=St.getParameter(F.UNPACK_IMAGE_HEIGHT),ms=St.getParameter(F.UNPACK_SKIP_PIXELS),vn=St.getParameter(F.UNPACK_SKIP_ROWS),Xr=St.getParameter(F.UNPACK_SKIP_IMAGES);St.pixelStorei(F.UNPACK_ROW_LENGTH,Le.width),St.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Le.height),St.pixelStorei(F.UNPACK_SKIP_PIXELS,Vt),St.pixelStorei(F.UNPACK_SKIP_ROWS,ee),St.pixelStorei(F.UNPACK_SKIP_IMAGES,pe);let Yi=E.isDataArrayTexture||E.isData3DTexture,gs=B.isDataArrayTexture||B.isData3DTexture;if(E.isDepthTexture){let ue=Gt.get(E),ln=Gt.get(B),Kn=Gt.get(ue.__renderTarget),De=Gt.get(ln.__renderTarget);St.bindFramebuffer(F.READ_FRAMEBUFFER,Kn.__webglFramebuffer),St.bindFramebuffer(F.DRAW_FRAMEBUFFER,De.__webglFramebuffer);for(let yn=0;yn<Lt;yn++)Yi&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Gt.get(E).__webglTexture,Y,pe+yn),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Gt.get(B).__webglTexture,Tt,sn+yn)),F.blitFramebuffer(Vt,ee,Vt+Pt,ee+At,zt,me,zt+Pt,me+At,F.DEPTH_BUFFER_BIT,F.NEAREST);St.bindFramebuffer(F.READ_FRAMEBUFFER,null),St.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(Y!==0||E.isRenderTargetTexture||Gt.has(E)){let ue=Gt.get(E),ln=Gt.get(B);St.bindFramebuffer(F.READ_FRAMEBUFFER,D),St.bindFramebuffer(F.DRAW_FRAMEBUFFER,V);for(let Kn=0;Kn<Lt;Kn++)Yi?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ue.__webglTexture,Y,pe+Kn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ue.__webglTexture,Y),gs?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ln.__webglTexture,Tt,sn+Kn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ln.__webglTexture,Tt),Y!==0?F.blitFramebuffer(Vt,ee,Vt+Pt,ee+At,zt,me,zt+Pt,me+At,F.COLOR_BUFFER_BIT,F.NEAREST):gs?F.copyTexSubImage3D(Ut,Tt,zt,me,sn+Kn,Vt,ee,Pt,At):F.copyTexSubImage2D(Ut,Tt,zt,me,Vt,ee,Pt,At);St.bindFramebuffer(F.READ_FRAMEBUFFER,null),St.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else gs?E.isDataTexture||E.isData3DTexture?F.texSubImage3D(Ut,Tt,zt,me,sn,Pt,At,Lt,Ne,En,Le.data):B.isCompressedArrayTexture?F.compressedTexSubImage3D(Ut,Tt,zt,me,sn,Pt,At,Lt,Ne,Le.data):F.texSubImage3D(Ut,Tt,zt,me,sn,Pt,At,Lt,Ne,En,Le):E.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Tt,zt,me,Pt,At,Ne,En,Le.data):E.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Tt,zt,me,Le.width,Le.height,Ne,Le.data):F.texSubImage2D(F.TEXTURE_2D,Tt,zt,me,Pt,At,Ne,En,Le);St.pixelStorei(F.UNPACK_ROW_LENGTH,xn),St.pixelStorei(F.UNPACK_IMAGE_HEIGHT,ve),St.pixelStorei(F.UNPACK_SKIP_PIXELS,ms),St.pixelStorei(F.UNPACK_SKIP_ROWS,vn),St.pixelStorei(F.UNPACK_SKIP_IMAGES,Xr),Tt===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&F.generateMipmap(Ut),St.unbindTexture()},this.initRenderTarget=function(E){Gt.get(E).__webglFramebuffer===void 0&&Kt.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Kt.setTextureCube(E,0):E.isData3DTexture?Kt.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Kt.setTexture2DArray(E,0):Kt.setTexture2D(E,0),St.unbindTexture()},this.resetState=function(){$=0,k=0,ot=null,St.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ti}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=_e._getDrawingBufferColorSpace(t),e.unpackColorSpace=_e._getUnpackColorSpace()}};function qn(i,t,e,n){return new Xo({glslVersion:dl,vertexShader:i,fragmentShader:t,uniforms:e,transparent:!0,depthTest:n,depthWrite:n,side:Ri})}function $i(i,t,e,n=!1){let s=qn(i,t,e,!1);return s.blending=n?eu:Rs,n&&(s.blendEquation=nu,s.blendSrc=il,s.blendDst=il),s}var Pn=`
precision highp float;
precision highp int;
uniform mat4 view;
uniform mat4 projection;
uniform vec3 eye;
uniform vec3 up;
uniform vec3 right;
uniform float pixel;   // metres per CSS pixel at a depth of one metre
uniform float ratio;   // device pixels per CSS pixel
uniform vec3 key;      // direction to the light
`,vl=`
// The direction to the side of a line through a node, at a right angle to "sight" (length 1),
// drawn out at a bend so that the ribbon keeps its width; sharp folds are cut off.
vec3 sideways(vec3 before, vec3 here, vec3 after, vec3 sight) {
  vec3 a = cross(here - before, sight);
  vec3 b = cross(after - here, sight);
  float la = length(a), lb = length(b);
  a = la > 0.0 ? a / la : vec3(0.0);
  b = lb > 0.0 ? b / lb : a;
  if (la == 0.0) a = b;
  vec3 sum = a + b;
  float size = length(sum);
  if (size < 0.7) return b;
  sum /= size;
  return sum / max(0.6, dot(sum, b));
}
`,qy=`${Pn}${vl}
uniform highp sampler2D points;
uniform int columns;
uniform int head;
in vec3 tint;
out float across;
out float age;
out vec3 colourOf;
vec3 point(int row, int step) {
  return texelFetch(points, ivec2((head + clamp(step, 0, columns - 1)) % columns, row), 0).xyz;
}
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  int row = i / columns, step = i % columns;
  vec3 here = point(row, step);
  vec3 side = sideways(point(row, step - 1), here, point(row, step + 1), normalize(eye - here));
  float perPixel = pixel * -(view * vec4(here, 1.0)).z;
  age = 1.0 - float(step) / float(columns - 1);
  colourOf = tint;
  gl_Position = projection * view * vec4(here + side * across * 2.0 * perPixel, 1.0);
}
`,Yy=`
precision highp float;
in float across;
in float age;
in vec3 colourOf;
out vec4 colour;
void main() {
  float cover = clamp(1.8 - 2.0 * abs(across), 0.0, 1.0);
  colour = vec4(colourOf, 0.75 * cover * (1.0 - age) * (1.0 - age));
}
`,Ky=`${Pn}
in vec3 position;
in vec4 ink;           // colour, kind: 0 ball, 1 eye bolt, 2 ring, 3 knot
in vec2 sizes;         // diameter [m], least diameter in CSS pixels
out vec4 colourOf;
out float diameter;    // CSS pixels
void main() {
  vec4 seen = view * vec4(position, 1.0);
  diameter = max(sizes.x / (pixel * -seen.z), sizes.y);
  colourOf = ink;
  gl_Position = projection * seen;
  seen.z *= 1.0 - min(0.5, pixel * diameter);  // before the rope that ends in it
  vec4 nearer = projection * seen;
  gl_Position.z = nearer.z / nearer.w * gl_Position.w;
  gl_PointSize = (diameter + 2.0) * ratio;
}
`,Zy=`${Pn}
in vec4 colourOf;
in float diameter;
out vec4 colour;
void main() {
  float radius = 0.5 * diameter;
  vec2 at = (gl_PointCoord * 2.0 - 1.0) * vec2(1.0, -1.0) * (radius + 1.0);
  int kind = int(colourOf.w + 0.5);
  if (kind == 2) {
    float band = abs(length(at) - radius + 1.2) - 1.2;
    colour = vec4(colourOf.rgb, clamp(0.5 - band, 0.0, 1.0));
  } else if (kind == 1) {
    float tube = 0.3 * radius;
    float x = (length(at) - 0.7 * radius) / tube;
    float z = sqrt(max(0.0, 1.0 - x * x));
    vec3 n = vec3(at / max(length(at), 1e-3) * clamp(x, -1.0, 1.0), z);
    float light = 0.42 + 0.62 * max(dot(n, normalize(vec3(-0.35, 0.8, 0.6))), 0.0);
    float glint = pow(max(dot(n, normalize(vec3(-0.2, 0.6, 0.9))), 0.0), 24.0);
    colour = vec4(colourOf.rgb * light + 0.25 * glint, clamp(tube * (1.0 - abs(x)) + 0.5, 0.0, 1.0));
  } else {
    float cover = clamp(radius + 0.5 - length(at), 0.0, 1.0);
    vec2 n = at / radius;
    float z = sqrt(max(0.0, 1.0 - dot(n, n)));
    float light = 0.62 + 0.42 * max(dot(vec3(n, z), normalize(vec3(0.35, 0.8, 0.7))), 0.0);
    float glint = pow(max(dot(vec3(n, z), normalize(vec3(0.2, 0.5, 0.9))), 0.0), 30.0);
    if (kind == 3) { // turns of a rope, over each other
      bool over = abs(n.x - n.y) < 0.5;
      float turns = (over ? n.x + n.y : n.x - n.y) * 2.6;
      light *= 0.62 + 0.45 * abs(cos(turns * 1.57)) * (over ? 1.0 : 0.82);
      glint = 0.0;
    }
    colour = vec4(colourOf.rgb * light + 0.18 * glint, cover);
  }
  if (colour.a <= 0.0) discard;
}
`,Jy=`${Pn}
uniform highp sampler2D points;
uniform int columns;
uniform float dot_;    // CSS pixels
void main() {
  vec4 here = texelFetch(points, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0);
  vec4 seen = view * vec4(here.xyz, 1.0);
  seen.z += 0.02 * -seen.z;
  gl_Position = projection * seen;
  gl_PointSize = here.w > 1e30 ? 0.0 : dot_ * ratio;
}
`,jy=`
precision highp float;
uniform vec3 ink;
out vec4 colour;
void main() {
  float away = length(gl_PointCoord * 2.0 - 1.0);
  float cover = 1.0 - smoothstep(0.7, 1.0, away);
  if (cover <= 0.0) discard;
  colour = vec4(ink, cover);
}
`,Qy=`${Pn}
in vec3 position;      // a place on the arrow's line
in vec3 line;          // the arrow's direction
in vec4 ink;           // colour, CSS pixels to the side
in float edge;         // half the arrow's width there [CSS pixels]
out vec3 colourOf;
out float away;
out float halfWidth;
void main() {
  vec3 side = cross(line, eye - position);
  float size = length(side);
  side = size > 0.0 ? side / size : right;
  float perPixel = pixel * -(view * vec4(position, 1.0)).z;
  colourOf = ink.rgb;
  away = ink.w;
  halfWidth = edge;
  gl_Position = projection * view * vec4(position + side * ink.w * perPixel, 1.0);
}
`,t_=`
precision highp float;
in vec3 colourOf;
in float away;
in float halfWidth;
uniform float round_;  // 1: shaded as a round bar
out vec4 colour;
void main() {
  float u = clamp(away / max(halfWidth, 1.0), -1.0, 1.0);
  float light = mix(1.0, 0.55 + 0.5 * sqrt(max(0.0, 1.0 - (u + 0.35) * (u + 0.35) / 1.9)), round_);
  colour = vec4(colourOf * light, clamp(halfWidth + 0.5 - abs(away), 0.0, 1.0));
}
`;var am=256,lm=7,e_=[0,1,2,1,3,2,4,5,6],ea=class{constructor(t,e=!1,n=e){let s=new en;for(let[o,a]of[["position",3],["line",3],["ink",4],["edge",1]]){let l=new tn(new Float32Array(a*lm*am),a);l.setUsage(ul),s.setAttribute(o,l)}let r=[];for(let o=0;o<am;o++)r.push(...e_.map(a=>a+lm*o));s.setIndex(r),this.mesh=new nn(s,qn(Qy,t_,{...t,round_:{value:Number(e)}},n)),this.mesh.frustumCulled=!1,this.mesh.renderOrder=e?.5:n?2.2:2.5}update(t,e){let n=Math.min(am,t.length);if(this.mesh.visible=n>0,!n)return;let s=this.mesh.geometry,[r,o,a,l]=["position","line","ink","edge"].map(c=>s.getAttribute(c));for(let c=0;c<n;c++){let{from:h,to:u,colour:d,pixels:f,head:p}=t[c],x=[u[0]-h[0],u[1]-h[1],u[2]-h[2]],g=Math.hypot(x[0],x[1],x[2]),m=p&&g>0?Math.min(.5,5.5*f*e/g):0,v=f/2,M=p?2.2*f:0;[[0,v,-1],[0,v,1],[1-m,v,-1],[1-m,v,1],[1-m,M,-1],[1-m,M,1],[1,0,0]].forEach(([R,T,y],A)=>{let U=lm*c+A;r.setXYZ(U,h[0]+R*x[0],h[1]+R*x[1],h[2]+R*x[2]),o.setXYZ(U,x[0],x[1],x[2]),a.setXYZW(U,d[0],d[1],d[2],y*(T&&T+1)),l.setX(U,T)})}r.needsUpdate=o.needsUpdate=a.needsUpdate=l.needsUpdate=!0,s.setDrawRange(0,e_.length*n)}};var v3=i=>i.toFixed(4),n_=`
float surface(vec3 p, int kind, vec3 axis, vec3 zero, vec4 size, float bevel) {
  float along = dot(p, axis);
  if (kind == 0) return along;
  if (kind == 1) return length(p) - size.x;
  if (kind == 4) {
    vec3 q = abs(vec3(dot(p, zero), dot(p, cross(axis, zero)), along)) - size.xyz;
    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0) - size.w;
  }
  vec3 across = p - along * axis;
  float rho = length(across);
  if (kind == 6) return size.x - (dot(across, size.yzw) > 0.0 ? abs(dot(across, cross(size.yzw, axis))) : rho);
  if (kind == 5) return length(vec2(rho - size.x, along)) - size.y;
  if (kind == 3) return length(vec2(rho, max(abs(along) - size.y, 0.0))) - size.x;
  vec2 q = vec2(rho - size.x, abs(along) - size.y) + bevel;
  return min(max(q.x, q.y), 0.0) + length(max(q, 0.0)) - bevel;
}
`,cm=`
uniform highp sampler2D solids;
uniform int solidCount;
${n_}
float awayFrom(int k, vec3 place) {
  vec4 centre = texelFetch(solids, ivec2(0, k), 0);
  vec4 axis = texelFetch(solids, ivec2(1, k), 0);
  vec3 zero = texelFetch(solids, ivec2(3, k), 0).xyz;
  return surface(place - centre.xyz, int(centre.w), axis.xyz, zero, texelFetch(solids, ivec2(2, k), 0), axis.w);
}
float awayFromAll(vec3 place) {
  float found = 1e30;
  for (int k = 0; k < solidCount; k++) found = min(found, awayFrom(k, place));
  return found;
}
// Ropes that are drawn thicker than they are lie on bodies, too: how far to lift a place off them.
vec3 lifted(vec3 place, float radius) {
  for (int k = 0; k < solidCount; k++) {
    float away = awayFrom(k, place);
    if (away >= radius) continue;
    float e = 0.2 * radius;
    vec3 slope = vec3(awayFrom(k, place + vec3(e, 0.0, 0.0)), awayFrom(k, place + vec3(0.0, e, 0.0)),
                      awayFrom(k, place + vec3(0.0, 0.0, e))) - away;
    if (dot(slope, slope) > 0.0) place += normalize(slope) * min(radius - away, 2.0 * radius);
  }
  return place;
}
`,qu=`
uniform vec4 box;      // of the screen, -1 to 1: left, bottom, right, top
void main() {
  vec2 part = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(mix(box.xy, box.zw, part), 0.5, 1.0);
}
`,hm=`${Pn}${n_}
uniform vec2 size;     // of the picture [CSS pixels]
uniform vec3 top;
uniform vec3 ahead;
uniform int kind;
uniform vec3 centre;   // of the body
uniform vec3 axis;
uniform vec3 zero;     // across the axis: of a box its first edge, of others where angles begin
uniform vec4 sizes;
uniform float bevel;
uniform float reach;   // of the body [m]
uniform vec3 middle;   // of the scene
uniform float radius;  // of the scene [m]
vec3 ray(out float straight) {
  vec2 at = gl_FragCoord.xy / ratio - 0.5 * size;
  vec3 found = ahead + (right * at.x + top * at.y) * pixel;
  straight = 1.0 / length(found);
  return found * straight;
}
// Where a ray leaves a trough: the wall before it is cut away. It fades far from the scene, as a plane does.
vec2 leave(vec3 from, vec3 way) {
  vec3 above = sizes.yzw, side = cross(above, axis);
  vec2 o = vec2(dot(from, side), dot(from, above)), d = vec2(dot(way, side), dot(way, above));
  float r = sizes.x, a = max(dot(d, d), 1e-12), b = dot(o, d), c = dot(o, o) - r * r, root = b * b - a * c;
  float rim = ${v3(Sl)} * r, wall = (sign(d.x) * r - o.x) / d.x, t = 0.0, cover = 0.0;
  float high = o.y + d.y * wall, perPixel = pixel * max(wall, 0.0) + 1e-9;
  if (wall > 0.0 && high > 0.0) { t = wall; cover = clamp((rim - high) / perPixel + 0.5, 0.0, 1.0); }
  float round = root > 0.0 ? (sqrt(root) - b) / a : 0.0;
  if (cover == 0.0 && round > 0.0 && o.y + d.y * round <= 0.0) { t = round; cover = 1.0; }
  float far = length(from + way * t + centre - middle) / (2.2 * radius);
  return vec2(t, cover * exp(-far * far * far));
}
// Go along a ray; returns the way to the surface, or to where the ray comes nearest, and how much of the pixel it
// covers.
vec2 follow(vec3 way, float straight) {
  vec3 from = eye - centre;
  if (kind == 0) {
    float t = -dot(from, axis) / dot(way, axis);
    vec3 p = from + way * t + centre - middle;
    float far = length(p) / (2.2 * radius);
    return vec2(t, t > 0.0 ? exp(-far * far * far) : 0.0);
  }
  if (kind == 6) return leave(from, way);
  float towards = -dot(from, way);
  float aside = dot(from, from) - towards * towards, room = reach + 2.0 * pixel * max(towards, 0.0);
  if (aside > room * room) return vec2(0.0);
  float t = max(0.0, min(towards, length(from)) - reach), end = towards + reach;
  float wide = pixel * straight; // of a pixel, per metre
  vec2 found = vec2(t, 1e9);
  for (int i = 0; i < 64; i++) {
    float away = surface(from + way * t, kind, axis, zero, sizes, bevel);
    float pixels = away / (wide * max(t, 1e-6));
    if (pixels < found.y) found = vec2(t, pixels);
    if (pixels < 0.1 || t > end) break;
    t += max(away, 0.1 * wide * t);
  }
  return vec2(found.x, clamp(1.1 - found.y, 0.0, 1.0));
}
`,i_=`${hm}
uniform int number;
out highp uvec4 info;
void main() {
  float straight;
  vec3 way = ray(straight);
  vec2 found = follow(way, straight);
  if (found.y < 0.5) discard;
  vec3 p = eye - centre + way * found.x;
  float depth = found.x * straight;
  float angle = atan(dot(p, cross(axis, zero)), dot(p, zero));
  float rho = max(length(p - dot(p, axis) * axis), 1e-9);
  info = uvec4(floatBitsToUint(depth), floatBitsToUint(angle), uint(number + 1),
               floatBitsToUint(pixel * depth / rho));
  gl_FragDepth = 0.5 + 0.5 * (projection[3][2] / depth - projection[2][2]);
}
`,s_=`${hm}
uniform vec3 paint;
uniform vec3 grid;
uniform float spacing; // of the floor's lines [m]
uniform float height;  // of the floor along up [m]
uniform int number;
uniform highp usampler2D info;
out vec4 colour;
vec3 normalAt(vec3 p, float e) {
  vec2 k = vec2(1.0, -1.0);
  return normalize(k.xyy * surface(p + k.xyy * e, kind, axis, zero, sizes, bevel) +
                   k.yyx * surface(p + k.yyx * e, kind, axis, zero, sizes, bevel) +
                   k.yxy * surface(p + k.yxy * e, kind, axis, zero, sizes, bevel) +
                   k.xxx * surface(p + k.xxx * e, kind, axis, zero, sizes, bevel));
}
// Whether the body is next to this pixel: only there it may cover a part of it.
bool atEdge() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uint own = uint(number + 1);
  return texelFetch(info, at + ivec2(1, 0), 0).z == own || texelFetch(info, at - ivec2(1, 0), 0).z == own ||
         texelFetch(info, at + ivec2(0, 1), 0).z == own || texelFetch(info, at - ivec2(0, 1), 0).z == own;
}
// How much of a pixel a groove covers that is "wide" and "away" from its middle.
float groove(float away, float wide, float perPixel) {
  return clamp((0.5 * wide - abs(away)) / perPixel + 0.5, 0.0, 1.0) * min(1.0, wide / perPixel);
}
float lines(vec2 at, float perPixel) {
  vec2 away = abs(fract(at - 0.5) - 0.5) / max(perPixel, 1e-6);
  vec2 part = clamp(1.0 - away, 0.0, 1.0);
  return max(part.x, part.y) * (1.0 - smoothstep(0.15, 0.5, perPixel));
}
void main() {
  float straight;
  vec3 way = ray(straight);
  uvec4 known = texelFetch(info, ivec2(gl_FragCoord.xy), 0);
  bool fades = kind == 0 || kind == 6;
  vec2 found = known.z == uint(number + 1) && !fades
    ? vec2(uintBitsToFloat(known.x) / straight, 1.0)
    : fades || atEdge() ? follow(way, straight) : vec2(0.0);
  if (found.y <= 0.0) discard;
  vec3 p = eye - centre + way * found.x;
  float depth = found.x * straight, perPixel = pixel * depth;
  vec3 n = kind == 0 ? axis * -sign(dot(axis, way)) : normalAt(p, max(0.4 * perPixel, 1e-5 * length(p)));
  float wrapped = max(dot(n, key) + 0.2, 0.0) / 1.2;
  float front = max(dot(n, -way), 0.0);
  float light = 0.5 + 0.22 * dot(n, up) + 0.6 * wrapped * wrapped + 0.12 * front;
  float sheen = 0.07 * pow(max(dot(n, normalize(key - way)), 0.0), 26.0);
  vec3 base = paint * paint;
  float along = dot(p, axis), rho = length(p - along * axis);
  if (kind == 2 && abs(dot(n, axis)) > 0.7 && sizes.x > 12.0 * perPixel) { // a turned face
    float wide = 0.018 * sizes.x;
    light *= 1.0 - 0.26 * (groove(rho - 0.84 * sizes.x, wide, perPixel) + groove(rho - 0.3 * sizes.x, wide, perPixel));
    light *= 1.0 - 0.4 * clamp((0.11 * sizes.x - rho) / perPixel + 0.5, 0.0, 1.0);
  }
  if (kind == 0) {
    vec3 first = normalize(abs(axis.z) < 0.9 ? cross(vec3(0.0, 0.0, 1.0), axis) : cross(vec3(1.0, 0.0, 0.0), axis));
    vec2 at = vec2(dot(p, first), dot(p, cross(axis, first))) / spacing;
    float ink = lines(at, perPixel / max(abs(dot(n, way)), 0.05) / spacing);
    base = mix(base, grid * grid, 0.7 * ink);
    sheen = 0.0;
  }
  float above = dot(p + centre, up) - height; // near the floor there is less light
  light *= 1.0 - 0.4 * exp(-max(above, 0.0) / (0.25 * min(reach, radius))) * max(0.0, 0.6 - dot(n, up));
  colour = vec4(sqrt(base * max(light, 0.0) + sheen), found.y);
  gl_FragDepth = 0.5 + 0.5 * (projection[3][2] / depth - projection[2][2]);
}
`,r_=`${hm}
uniform float height;
uniform float ink;
out vec4 colour;
void main() {
  float straight;
  vec3 way = ray(straight);
  float down = dot(way, up);
  if (down > -1e-4) discard;
  vec3 q = eye + way * ((dot(eye, up) - height) / -down) - centre;
  vec3 level = key - up * dot(key, up);
  vec3 light = normalize(up + 0.75 * level / dot(key, up));
  float towards = -dot(q, light), least = 1.0;
  vec3 past = q + light * towards; // where the way to the light comes nearest to the middle
  float room = 1.05 * reach + 0.22 * max(towards, 0.0);
  if (dot(past, past) > room * room && dot(q, q) > 4.0 * reach * reach) discard;
  float t = max(0.02 * reach, towards - reach), end = towards + reach;
  for (int i = 0; i < 20 && t < end; i++) {
    float away = surface(q + light * t, kind, axis, zero, sizes, bevel);
    least = min(least, away / (0.22 * t + 0.01 * reach));
    if (least < -1.0) break;
    t += clamp(away, 0.06 * reach, 0.5 * reach);
  }
  float dark = 1.0 - smoothstep(-1.0, 1.0, least);
  float near = exp(-max(surface(q, kind, axis, zero, sizes, bevel), 0.0) / (0.16 * min(reach, radius)));
  dark = max(0.8 * dark, 0.75 * near * near);
  if (dark < 0.004) discard;
  colour = vec4(0.0, 0.0, 0.0, ink * dark);
}
`,o_=`
out vec3 on;           // a place on the rope's middle
out vec3 along;
out float thickness;   // radius as drawn [m]
void main() {
  int i = gl_VertexID >> 1;
  vec3 here = point(i).xyz;
  vec3 before = look.y > 0.5 ? point(i - 1).xyz : here;
  vec3 after = look.z > 0.5 ? point(i + 1).xyz : here;
  float perPixel = pixel * max(-(view * vec4(here, 1.0)).z, 1e-3);
  thickness = max(look.x, 0.5 * least * perPixel);
  float away = awayFromAll(here);
  on = lifted(here, thickness);
  along = after - before;
  along = length(along) > 0.0 ? normalize(along) : right;
  float wide = away < 4.0 * thickness && point(i).w < 1e30 ? 3.2 * thickness : 0.0;
  vec3 side = sideways(before, here, after, normalize(eye - here));
  float across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  gl_Position = projection * view * vec4(on + side * across * wide, 1.0);
}
`,a_=`${Pn}
uniform highp sampler2D backdrop;
uniform highp usampler2D info;
uniform vec2 size;
uniform vec3 top;
uniform vec3 ahead;
uniform float ink;
uniform int coarse;
in vec3 on;
in vec3 along;
in float thickness;
out vec4 colour;
void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy) / coarse;
  uvec4 known = texelFetch(info, texel, 0);
  if (known.z == 0u) discard;
  vec2 at = gl_FragCoord.xy / ratio - 0.5 * size;
  vec3 place = eye + (ahead + (right * at.x + top * at.y) * pixel) * uintBitsToFloat(known.x);
  vec3 way = place - on + 0.5 * thickness * key; // the shadow falls away from the light
  way -= along * dot(way, along);
  float far = length(way) / max(thickness, 1e-9);
  float dark = 0.85 * ink * (1.0 - smoothstep(0.7, 2.7, far));
  if (dark < 0.004) discard;
  colour = vec4(texelFetch(backdrop, texel, 0).rgb * (1.0 - dark), 1.0);
}
`,l_=`
precision highp float;
uniform highp sampler2D backdrop;
uniform highp usampler2D info;
uniform highp sampler2D turns; // of each body [rad], and whether it ever turns
uniform vec2 depths;   // of the projection
uniform int coarse;    // pixels each way for one of the backdrop's
out vec4 colour;
const float MARKS = 6.0;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy) / coarse;
  colour = texelFetch(backdrop, at, 0);
  uvec4 known = texelFetch(info, at, 0);
  if (known.z == 0u) { gl_FragDepth = 1.0; return; }
  float depth = uintBitsToFloat(known.x);
  gl_FragDepth = 0.5 + 0.5 * (depths.y / depth - depths.x);
  vec4 turn = texelFetch(turns, ivec2(int(known.z) - 1, 0), 0);
  if (turn.y < 0.5) return;
  float part = (uintBitsToFloat(known.y) - turn.x) / 6.2831853;
  float sector = fract(part * MARKS), first = floor(mod(part * MARKS + 0.5, MARKS));
  float away = (0.5 - abs(sector - 0.5)) * 6.2831853 / MARKS; // from the nearest mark [rad]
  float fine = uintBitsToFloat(known.w); // of the angle, that one pixel takes
  float wide = first < 0.5 ? min(0.16, 2.6 * fine) : min(0.05, 1.1 * fine); // lines, narrower near the axis
  float cover = clamp((wide - away) / max(fine, 1e-4) + 0.5, 0.0, 1.0) * smoothstep(1.2, 0.3, fine);
  colour.rgb *= 1.0 - 0.42 * cover;
}
`;var c_=`
uniform vec3 centre;   // of the body
uniform vec3 axis;     // its third direction
uniform vec3 zero;     // its first
mat3 frame() { return mat3(zero, cross(axis, zero), axis); }
`,um=`${Pn}
${c_}
in vec3 position;
in vec3 normal;
out vec3 place;
out vec3 outward;
void main() {
  place = centre + frame() * position;
  outward = frame() * normal;
  gl_Position = projection * view * vec4(place, 1.0);
}
`,h_=`${Pn}
in vec3 place;
in vec3 outward;
float depthOf() { return -(view * vec4(place, 1.0)).z; }
`,u_=`${h_}
uniform vec3 paint;
uniform float height;  // of the floor along up [m]
uniform float reach;   // of the body [m]
uniform float radius;  // of the scene [m]
out vec4 colour;
void main() {
  vec3 way = normalize(place - eye), n = normalize(outward);
  float wrapped = max(dot(n, key) + 0.2, 0.0) / 1.2;
  float light = 0.5 + 0.22 * dot(n, up) + 0.6 * wrapped * wrapped + 0.12 * max(dot(n, -way), 0.0);
  float sheen = 0.07 * pow(max(dot(n, normalize(key - way)), 0.0), 26.0);
  float above = dot(place, up) - height; // near the floor there is less light
  light *= 1.0 - 0.4 * exp(-max(above, 0.0) / (0.25 * min(reach, radius))) * max(0.0, 0.6 - dot(n, up));
  colour = vec4(sqrt(paint * paint * max(light, 0.0) + sheen), 1.0);
}
`,d_=`${h_}
uniform int number;
out highp uvec4 info;
void main() { info = uvec4(floatBitsToUint(depthOf()), 0u, uint(number + 1), 0u); }
`,f_=`${Pn}
${c_}
uniform float height;
in vec3 position;
in vec3 normal;
out float lit;
void main() {
  vec3 level = key - up * dot(key, up);
  vec3 light = normalize(up + 0.75 * level / dot(key, up));
  vec3 place = centre + frame() * position;
  float above = max(dot(place, up) - height, 0.0);
  lit = dot(frame() * normal, light);
  gl_Position = projection * view * vec4(place - light * (above / dot(light, up)), 1.0);
}
`,p_=`
precision highp float;
uniform float ink;
in float lit;
out vec4 colour;
void main() {
  if (lit <= 0.0) discard;
  colour = vec4(0.0, 0.0, 0.0, 0.6 * ink);
}
`;function m_({places:i,normals:t},e){let n=qn(um,u_,e,!0),s=$i(um,d_,e);s.depthTest=s.depthWrite=!0;let r=qn(f_,p_,e,!1);return[n,s,r].map(o=>{let a=new en;a.setAttribute("position",new tn(i,3)),a.setAttribute("normal",new tn(t,3));let l=new nn(a,o);return l.frustumCulled=!1,l})}var _3=64,Ku=[-1,-1,1,1],w3=1.35,Zu=class{constructor(t,e){this.shared=t,this.picture=e,this.all=[],this.paint={value:new J},this.ink={value:.5},this.height={value:0},this.middle={value:new J},this.radius={value:1},this.near={value:Yu(new Float32Array(16),4,1)},this.count={value:0},this.turns={value:Yu(new Float32Array(4),1,1)},this.target=new zn(1,1,{format:jo,type:vi,internalFormat:"RGBA32UI",minFilter:rn,magFilter:rn}),this.info={value:this.target.texture},this.colours=new as,this.depths=new as,this.drawn=[];for(let n of[this.colours,this.depths])n.matrixWorldAutoUpdate=!1}setTheme(t){this.paint.value.set(...t.body),this.ink.value=t.dark?.62:.36}resize(t,e){this.target.setSize(t,e)}take(t){if(t===this.all)return!1;this.all=t;for(let{meshes:r}of this.drawn)for(let o of r)o.removeFromParent(),o.geometry.dispose(),o.material.dispose();this.drawn=t.map((r,o)=>this.make(r,o));let e=t.filter(({kind:r})=>r!=="mesh").slice(0,_3),n=new Float32Array(16*Math.max(1,e.length));e.forEach((r,o)=>{n.set([...r.center,r.number,...r.axis,Ad(r)],16*o),n.set([...r.size.map(dm),...r.zero],16*o+8)}),this.near.value.dispose(),this.near.value=Yu(n,4,Math.max(1,e.length)),this.count.value=e.length,this.turns.value.dispose();let s=new Float32Array(4*Math.max(1,t.length));return this.turns.value=Yu(s,Math.max(1,t.length),1),!0}make(t,e){let n={...this.shared,...this.picture,kind:{value:Sd.indexOf(t.kind)},centre:{value:new J(...t.center)},axis:{value:new J(...t.axis)},zero:{value:new J(...t.zero)},sizes:{value:new We(...t.size.map(dm))},bevel:{value:Ad(t)},reach:{value:dm(t.reach)},number:{value:e},paint:this.paint,ink:this.ink,height:this.height,middle:this.middle,radius:this.radius},s=[0,1].map(()=>({value:new We(...Ku)})),r=t.surface?m_(t.surface,n):M3(n,s,this.info);return this.colours.add(r[0],r[2]),this.depths.add(r[1]),{solid:t,boxes:s,meshes:r}}turn(t){let e=this.turns.value.image.data;this.all.forEach((n,s)=>{e[4*s]=t[s]%(2*Math.PI),e[4*s+1]=El(n)?1:0}),this.turns.value.needsUpdate=!0}draw(t,e,n,s,r,o){let a=s.eyeHeight(r.height)>0;this.height.value=r.height,this.middle.value.set(o.center[0],o.center[1],o.center[2]),this.radius.value=o.radius,this.drawn.forEach(({solid:c,boxes:h,meshes:u})=>{let d=Tl(c),f=Number.isFinite(c.reach);h[0].value.set(...f?g_(s,d):Ku);let p=f?b3(c,s,r.height):null;h[1].value.set(...p?g_(s,p):Ku),u[2].visible=a&&f;let x=Ht(c.center,s.toward);u[0].renderOrder=1+Math.atan(x/o.radius),u[2].renderOrder=-1});let l=t.autoClear;t.autoClear=!1,t.setRenderTarget(this.target),t.clear(),t.render(this.depths,e),t.setRenderTarget(n),t.clearDepth(),t.render(this.colours,e),t.setRenderTarget(null),t.autoClear=l}dispose(){this.target.dispose(),this.near.value.dispose(),this.turns.value.dispose()}},dm=i=>Math.min(i,1e15);function g_(i,t){let e=[1,1,-1,-1];for(let r of t){let[o,a,l]=i.project(...r);if(l<.02*i.pose.distance)return Ku;let[c,h]=[2*o/i.width-1,1-2*a/i.height];e[0]=Math.min(e[0],c),e[1]=Math.min(e[1],h),e[2]=Math.max(e[2],c),e[3]=Math.max(e[3],h)}let[n,s]=[3/i.width,3/i.height];return[Math.max(-1,e[0]-n),Math.max(-1,e[1]-s),Math.min(1,e[2]+n),Math.min(1,e[3]+s)]}function b3(i,t,e){let{up:n,light:s,first:r,second:o}=t,a=lt(s,n,-Ht(s,n)),l=Dt(a,.75/Ht(s,n)),c=Ht(i.center,n)-e,h=w3*i.reach;return[Math.max(0,c-h),Math.max(0,c+h)].flatMap(u=>{let d=lt(lt(i.center,n,-c),l,-u),f=h+.3*u;return[-1,1].flatMap(p=>[-1,1].map(x=>lt(lt(d,r,p*f),o,x*f)))})}function M3(i,[t,e],n){let s=qn(qu,s_,{...i,box:t,info:n},!0),r=$i(qu,i_,{...i,box:t});r.depthTest=r.depthWrite=!0;let o=qn(qu,r_,{...i,box:e},!1);return[s,r,o].map(a=>S3(a))}function S3(i){let t=new en;t.setIndex([0,1,2,1,3,2]);let e=new nn(t,i);return e.frustumCulled=!1,e}function Yu(i,t,e){let n=new Gi(i,t,e,Vn,Hn);return n.internalFormat="RGBA32F",n.needsUpdate=!0,n}var x_=150,fm=`
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.5, 1.0);
}
`,E3=`${Pn}
uniform vec2 size;     // of the picture [CSS pixels]
uniform vec3 top;
uniform vec3 ahead;
uniform vec3 first;
uniform vec3 second;
uniform vec3 center;   // on the ground, on a crossing of lines
uniform float spacing; // of the lines [m]
uniform float reach;   // how far the floor is seen [m]
uniform float solid;   // 1: there is a ground to land on
uniform vec3 sky;
uniform vec3 horizon;
uniform vec3 ground;
uniform vec3 grid;
uniform float pool;    // how much lighter the middle is
out vec4 colour;
// How much of a pixel a line covers: "at" in lines, "wide" pixels; "step_" lines per pixel.
float line(float at, float step_, float wide) {
  float away = abs(fract(at - 0.5) - 0.5) / max(step_, 1e-6);
  float part = clamp(0.5 * wide + 0.5 - away, 0.0, 1.0);
  return mix(part, min(1.0, wide * step_), smoothstep(0.15, 0.5, step_));
}
void main() {
  vec2 at = gl_FragCoord.xy / ratio - 0.5 * size;
  vec3 ray = ahead + (right * at.x + top * at.y) * pixel;
  float rise = dot(normalize(ray), up);
  vec3 highest = ahead + top * (0.5 * size.y * pixel);
  float most = max(dot(normalize(highest), up), 0.12);
  vec3 shown = mix(horizon, sky, smoothstep(0.0, 1.0, clamp(rise / most, 0.0, 1.0)));
  float above = dot(eye - center, up);
  float away = above / max(abs(dot(ray, up)), 1e-5) * (rise < 0.0 ? 1.0 : -1.0);
  if (away > 0.0) {
    vec3 place = eye + ray * away - center;
    vec2 q = vec2(dot(place, first), dot(place, second)) / spacing;
    float far = length(q) * spacing / reach;
    float fade = exp(-2.4 * far * far);
    // The size of a pixel on the floor: along the ray it is drawn out.
    float perPixel = pixel * away * length(ray);
    float drawn = perPixel / max(abs(rise), 1e-3);
    vec3 level = ray - up * dot(ray, up);
    vec2 flow = abs(vec2(dot(level, first), dot(level, second))) / max(length(level), 1e-6);
    vec2 step_ = (perPixel + (drawn - perPixel) * flow) / spacing;
    float fine = max(line(q.x, step_.x, 1.0), line(q.y, step_.y, 1.0));
    float coarse = max(line(q.x / 5.0, step_.x / 5.0, 1.5), line(q.y / 5.0, step_.y / 5.0, 1.5));
    float ink = max(0.5 * fine * exp(-5.0 * far * far), coarse) * fade;
    if (above > 0.0) {
      vec3 floor_ = ground + pool * exp(-9.0 * far * far);
      shown = mix(horizon, floor_, clamp(1.25 * fade, 0.0, 1.0));
      shown = mix(shown, grid, 0.9 * ink);
    } else shown = mix(shown, grid, 0.5 * ink);
  }
  // A little noise, so that no bands are seen.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  colour = vec4(shown + (noise - 0.5) / 255.0, 1.0);
}
`,T3=`
precision highp float;
uniform highp sampler2D backdrop;
uniform int coarse;
out vec4 colour;
void main() { colour = texelFetch(backdrop, ivec2(gl_FragCoord.xy) / coarse, 0); }
`,Ju=class{constructor(t,e){this.shared=t,this.soft=e,this.full=[1,1],this.moved=-1/0,this.version=-1;let n=()=>({value:new J});this.uniforms={size:{value:new xe(1,1)},top:n(),ahead:n(),first:n(),second:n(),center:n(),spacing:{value:1},reach:{value:1},solid:{value:0},sky:n(),horizon:n(),ground:n(),grid:n(),pool:{value:0}},this.target=new zn(1,1),this.target.texture.minFilter=this.target.texture.magFilter=rn,this.texture={value:this.target.texture},this.scene=new as,this.scene.add(pm($i(fm,E3,{...t,...this.uniforms}))),this.mesh=pm($i(fm,T3,{backdrop:this.texture,coarse:t.coarse})),this.solids=new Zu(t,this.uniforms),this.depths={value:new xe};let s=$i(fm,l_,{backdrop:this.texture,info:this.solids.info,turns:this.solids.turns,depths:this.depths,coarse:t.coarse});s.depthTest=s.depthWrite=!0,s.depthFunc=zo,this.deep=pm(s),this.mesh.renderOrder=this.deep.renderOrder=-5,this.key=""}setTheme(t){let{sky:e,horizon:n,ground:s,grid:r,pool:o}=this.uniforms;e.value.set(...t.background),n.value.set(...t.horizon),s.value.set(...t.ground),r.value.set(...t.grid),o.value=sg(t.dark),this.solids.setTheme(t),this.key=""}resize(t,e){this.full=[t,e],this.fit()}fit(){let[t,e]=this.full.map(n=>Math.ceil(n/this.shared.coarse.value));this.target.setSize(t,e),this.solids.resize(t,e),this.key=""}get unfinished(){return this.shared.coarse.value>1&&performance.now()-this.moved>x_}choose(t){let e=this.version>=0&&t!==this.version;if(this.version=t,!this.soft)return;e&&(this.moved=performance.now());let n=performance.now()-this.moved>x_?1:2;n!==this.shared.coarse.value&&(this.shared.coarse.value=n,this.fit())}update(t,e,{ground:n,camera:s,solids:r,turns:o,room:a}){this.choose(s.version),this.solids.take(r)&&(this.key=""),this.deep.visible=r.length>0,this.mesh.visible=!this.deep.visible,r.length&&this.solids.turn(o),this.depths.value.set(s.projection[10],s.projection[14]);let l=[s.version,n.height,n.spacing,n.solid,...n.center].join();if(l===this.key)return;this.key=l;let{uniforms:c}=this;c.size.value.set(s.width,s.height),c.top.value.set(...s.top),c.ahead.value.set(-s.toward[0],-s.toward[1],-s.toward[2]),c.first.value.set(...s.first),c.second.value.set(...s.second),c.center.value.set(...n.center),c.spacing.value=n.spacing,c.reach.value=n.radius,c.solid.value=n.solid?1:0;let{ratio:h,coarse:u}=this.shared;h.value/=u.value,t.setRenderTarget(this.target),t.render(this.scene,e),t.setRenderTarget(null),r.length&&this.solids.draw(t,e,this.target,s,n,a),h.value*=u.value}dispose(){this.target.dispose(),this.solids.dispose()}};function pm(i){let t=new en;t.setIndex([0,1,2]);let e=new nn(t,i);return e.frustumCulled=!1,e}var A3={round:0,eye:1,ring:2,knot:3},ju=class{constructor(t){this.room=0,this.points=new Fr(void 0,qn(Ky,Zy,t,!0)),this.points.frustumCulled=!1,this.points.renderOrder=3,this.grow(32)}grow(t){this.room=t,this.points.geometry.dispose();let e=new en;for(let[n,s]of[["position",3],["ink",4],["sizes",2]]){let r=new tn(new Float32Array(s*t),s);r.setUsage(ul),e.setAttribute(n,r)}this.points.geometry=e}update(t){t.length>this.room&&this.grow(2*t.length);let e=this.points.geometry,[n,s,r]=["position","ink","sizes"].map(o=>e.getAttribute(o));t.forEach((o,a)=>{n.setXYZ(a,o.x,o.y,o.z);let[l,c,h]=o.colour;s.setXYZW(a,l,c,h,A3[o.kind]),r.setXY(a,o.size,o.pixels)}),n.needsUpdate=s.needsUpdate=r.needsUpdate=!0,e.setDrawRange(0,t.length),this.points.visible=t.length>0}};var mm=`
uniform highp sampler2D points;
uniform int columns;
uniform float least;   // least width in CSS pixels
in vec4 look;          // radius [m], has a point before, after, length of rope to a free end [m]
vec4 point(int i) { return texelFetch(points, ivec2(i % columns, i / columns), 0); }
`,R3=`
#ifdef SOLIDS
${cm}
#endif
`,v_=`${Pn}${vl}${mm}${R3}
uniform highp sampler2D normals; // of the rope, and the length of rope up to here [m]
uniform float laid;    // 1: there are strands
uniform float thick;   // the least radius as drawn in the scene's middle [m]
in vec3 tint;
out float across;
out float halfWidth;   // CSS pixels
out float value;
out float phase;       // turns of the strands
out vec2 turn;         // the rope's normal, as seen: to the side and towards the eye
out float slope;       // of the rope towards the eye
out float toEnd;       // radii to a free end
out vec3 side;
out vec3 toward;
out vec3 ropeTint;
out float behind;
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec4 here = point(i);
  vec3 before = look.y > 0.5 ? point(i - 1).xyz : here.xyz;
  vec3 after = look.z > 0.5 ? point(i + 1).xyz : here.xyz;
  vec3 sight = normalize(eye - here.xyz);
  vec3 out_ = sideways(before, here.xyz, after, sight);
  float depth = -(view * vec4(here.xyz, 1.0)).z;
  behind = depth > 0.0 ? 0.0 : 1.0;
  float perPixel = pixel * max(depth, 1e-3);
  halfWidth = max(look.x / perPixel, 0.5 * least);
  value = here.w;
  ropeTint = tint;
  vec3 along = after - before;
  along = length(along) > 0.0 ? normalize(along) : right;
  float size = length(out_);
  side = size > 0.0 ? out_ / size : right;
  toward = normalize(cross(side, along));
  vec4 material = laid < 0.5 ? vec4(up, 0.0) : texelFetch(normals, ivec2(i % columns, i / columns), 0);
  turn = vec2(dot(material.xyz, side), dot(material.xyz, toward));
  float radius = max(look.x, 1e-9); // where ropes are drawn thicker than they are, their lay is longer
  float lay = 7.0 * radius * exp2(floor(log2(max(thick / radius, 1.0)) + 0.9));
  phase = material.w / lay;
  float cot = dot(along, sight) / max(length(cross(along, sight)), 1e-3);
  slope = cot / sqrt(1.0 + 0.6 * cot * cot);
  toEnd = look.w / (halfWidth * perPixel);
  vec3 middle = here.xyz;
#ifdef SOLIDS
  middle = lifted(middle, halfWidth * perPixel);
#endif
  vec3 place = middle + out_ * across * (halfWidth + 1.0) * perPixel;
  gl_Position = projection * view * vec4(place, 1.0);
}
`,y_=`${Pn}
uniform sampler2D map;
uniform vec2 range;    // values of the map's two ends
uniform bool plain;
uniform float rim;     // what is left of the light at the rope's edge: 1 where the floor is dark
uniform float laid;    // 1: draw strands
in float across;
in float halfWidth;
in float value;
in float phase;
in vec2 turn;
in float slope;
in float toEnd;
in vec3 side;
in vec3 toward;
in vec3 ropeTint;
in float behind;       // > 0: a part of a segment that ends behind the eye
out vec4 colour;
const float CENTRE = 0.5359, STRAND = 0.4641; // of three strands in a rope of radius 1
void main() {
  if (behind > 0.0 || value > 1e30) discard;
  float w = across * (halfWidth + 1.0);
  float u = clamp(w / halfWidth, -1.0, 1.0);
  vec3 n = vec3(u, sqrt(1.0 - u * u), 0.0); // to the side, towards the eye, along
  float edge = 1.0, shade = 1.0;
  float strands = laid * smoothstep(1.6, 3.2, halfWidth);
  bool whipped = toEnd < 4.2;
  if (strands > 0.0 && !whipped) {
    float angle = 6.2831853 * (phase + slope * n.y * 0.1214);
    float c = cos(angle), s = sin(angle);
    vec2 t = normalize(turn + 1e-6);
    vec2 centre = CENTRE * vec2(t.x * c + t.y * s, t.y * c - t.x * s);
    float best = -2.0, outer = -1.0;
    vec2 hit = centre;
    for (int k = 0; k < 3; k++) {
      float off = u - centre.x;
      float q = STRAND * STRAND - off * off;
      float z = centre.y + sqrt(max(q, 0.0));
      if (q > 0.0 && z > best) { best = z; hit = centre; }
      outer = max(outer, sign(u) * centre.x + STRAND);
      centre = vec2(-0.5 * centre.x - 0.8660254 * centre.y, 0.8660254 * centre.x - 0.5 * centre.y);
    }
    vec2 o = vec2(u - hit.x, max(best, hit.y) - hit.y) / STRAND;
    vec3 lie = vec3(0.8976 * hit.y, -0.8976 * hit.x, 1.0); // the direction of the strand
    vec3 m = vec3(o, 0.0);
    m = normalize(m - lie * (dot(m, lie) / dot(lie, lie)));
    float groove = smoothstep(0.46, 0.93, length(vec2(u, best)));
    n = normalize(mix(n, m, strands));
    edge = mix(1.0, outer, strands);
    shade = mix(1.0, 0.42 + 0.58 * groove, strands * mix(0.7, 1.0, smoothstep(4.0, 10.0, halfWidth)));
  }
  float cover = clamp(edge * halfWidth + 0.5 - abs(w), 0.0, 1.0);
  if (cover <= 0.0) discard;
  float part = (value - range.x) / max(range.y - range.x, 1e-30);
  vec3 base = plain ? ropeTint : texture(map, vec2(clamp(part, 0.002, 0.998), 0.5)).rgb;
  if (whipped) {
    base = vec3(0.86, 0.82, 0.74); // whipped with twine
    shade = 0.8 + 0.2 * cos(toEnd * 9.0);
  }
  vec3 normal = normalize(side) * n.x + normalize(toward) * n.y + cross(toward, side) * n.z;
  float wrapped = max(dot(normal, key) + 0.25, 0.0) / 1.25;
  float front = max(n.y, 0.0);
  float light = (0.36 + 0.2 * dot(normal, up) + 0.62 * wrapped * wrapped + 0.3 * front) * shade;
  vec3 half_ = normalize(key + normalize(toward));
  float sheen = 0.1 * pow(max(dot(normal, half_), 0.0), 22.0);
  float band = 1.0 - smoothstep(0.7, 2.0, edge * halfWidth - abs(w));
  float bright = dot(base * base, vec3(0.2126, 0.7152, 0.0722)); // what is dark needs no rim
  band *= smoothstep(0.08, 0.2, bright);
  vec3 lit = base * base * light * mix(1.0, rim, band) + sheen * shade;
  colour = vec4(sqrt(lit), cover);
}
`,__=`${Pn}${vl}${mm}
uniform float height;  // of the ground along up [m]
out float across;
out float strength;
out float sharp;
vec3 fallen(int i) {
  vec3 p = point(i).xyz;
  float above = dot(p, up) - height;
  vec3 level = key - up * dot(key, up);
  return p - above * (up + 0.75 * level / dot(key, up));
}
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec3 here = fallen(i);
  vec3 before = look.y > 0.5 ? fallen(i - 1) : here;
  vec3 after = look.z > 0.5 ? fallen(i + 1) : here;
  vec3 side = sideways(before, here, after, up);
  float above = dot(point(i).xyz, up) - height;
  float perPixel = pixel * max(-(view * vec4(here, 1.0)).z, 1e-3);
  float radius = max(look.x, 0.5 * least * perPixel);
  float blur = 0.11 * max(above, 0.0);
  float wide = sqrt(radius * radius + blur * blur);
  strength = above < -radius ? 0.0 : radius / (radius + 0.38 * blur);
  if (point(i).w > 1e30) strength = 0.0;
  strength *= min(look.y, look.z); // it fades out at the ends
  sharp = radius / wide;
  gl_Position = projection * view * vec4(here + side * across * 1.7 * wide, 1.0);
}
`,w_=`
precision highp float;
uniform highp sampler2D backdrop;
#ifdef SOLIDS
uniform highp usampler2D info;
#endif
uniform float ink;
uniform int coarse;    // pixels each way for one of the backdrop's
in float across;
in float strength;
in float sharp;
out vec4 colour;
void main() {
#ifdef SOLIDS
  if (texelFetch(info, ivec2(gl_FragCoord.xy) / coarse, 0).z != 0u) discard; // a body is before the floor
#endif
  float soft = exp(-3.0 * across * across) - 0.05;
  float hard = 1.0 - smoothstep(0.45, 0.8, abs(across));
  float dark = ink * strength * max(mix(soft, hard, sharp * sharp), 0.0);
  colour = vec4(texelFetch(backdrop, ivec2(gl_FragCoord.xy) / coarse, 0).rgb * (1.0 - dark), 1.0);
}
`,b_=`${Pn}${vl}${mm}${cm}${o_}`;var S_=1e6,Qu=class{constructor(t,{texture:e,solids:n,uniforms:s}){this.uniforms={points:{value:null},normals:{value:null},columns:{value:1},least:{value:4},thick:{value:1},laid:{value:1},map:{value:null},range:{value:new xe(0,1)},plain:{value:!1},rim:{value:1},height:{value:0}},this.shadowInk={value:.3},this.dotInk={value:new J(0,0,0)};let r={solids:n.near,solidCount:n.count,info:n.info},o={...t,...this.uniforms,...r};this.ropes=new nn(void 0,qn(v_,y_,o,!0)),this.shadow=new nn(void 0,$i(__,w_,{...o,backdrop:e,ink:this.shadowInk},!0));let{size:a,top:l,ahead:c}=s;this.contact=new nn(void 0,$i(b_,a_,{...o,size:a,top:l,ahead:c,backdrop:e,ink:this.shadowInk},!0)),this.dots=new Fr(void 0,qn(Jy,jy,{...o,ink:this.dotInk,dot_:{value:5}},!0)),this.shadow.renderOrder=-2,this.contact.renderOrder=-1,this.solid=!1,this.ropes.renderOrder=1,this.dots.renderOrder=2;for(let h of[this.ropes,this.shadow,this.contact,this.dots])h.frustumCulled=!1}setTheme(t){this.uniforms.map.value?.dispose(),this.uniforms.map.value=P3(t.dark),this.uniforms.rim.value=t.rim,this.shadowInk.value=t.dark?.75:.42,this.dotInk.value.set(...t.node)}setSolid(t){if(this.contact.visible=t,t!==this.solid){this.solid=t;for(let{material:e}of[this.ropes,this.shadow])e.defines=t?{SOLIDS:1}:{},e.needsUpdate=!0}}setLine(t){let e=I3(t.shape);this.ropes.geometry.dispose(),this.ropes.geometry=e,this.shadow.geometry=this.contact.geometry=e;let n=new en,s=t.shape.ropes.flatMap(({first:r,count:o})=>Array.from({length:Math.ceil(o/t.steps)},(a,l)=>r+l*t.steps));n.setIndex(new tn(new Uint32Array(s),1)),this.dots.geometry.dispose(),this.dots.geometry=n;for(let r of["points","normals"])this.uniforms[r].value?.dispose(),this.uniforms[r].value=C3(t[r]);this.uniforms.columns.value=Tr(t.points.length/4)[0],this.uniforms.laid.value=t.framed?1:0}moved(){let{points:t,normals:e,laid:n}=this.uniforms;t.value&&(t.value.needsUpdate=!0),e.value&&n.value&&(e.value.needsUpdate=!0)}dispose(){this.uniforms.points.value?.dispose(),this.uniforms.normals.value?.dispose(),this.uniforms.map.value?.dispose(),this.ropes.geometry.dispose(),this.dots.geometry.dispose()}};function C3(i){let[t,e]=Tr(i.length/4),n=new Gi(i,t,e,Vn,Hn);return n.internalFormat="RGBA32F",n.needsUpdate=!0,n}function I3(i){let t=new Float32Array(8*i.nodes),e=new Float32Array(6*i.nodes),n=[];for(let r of i.ropes)for(let o=0;o<r.count;o++){let a=r.first+o,l=o>0,c=o<r.count-1,h=Math.min(r.loose[0]?o*r.spacing:S_,r.loose[1]?(r.count-1-o)*r.spacing:S_);for(let u of[2*a,2*a+1])t.set([r.radius,Number(l),Number(c),h],4*u),e.set(r.colour,3*u);if(c){let u=2*a;n.push(u,u+1,u+2,u+1,u+3,u+2)}}let s=new en;return s.setAttribute("look",new tn(t,4)),s.setAttribute("tint",new tn(e,3)),s.setIndex(new tn(new Uint32Array(n),1)),s}function P3(i){let t=new Uint8Array(4*256);io(i).forEach((n,s)=>t.set([...n.map(r=>Math.round(255*r)),255],4*s));let e=new Gi(t,256,1);return e.minFilter=kn,e.magFilter=kn,e.needsUpdate=!0,e}var td=class{constructor(t){this.uniforms={points:{value:null},columns:{value:360},head:{value:0}},this.mesh=new nn(void 0,qn(qy,Yy,{...t,...this.uniforms},!1)),this.mesh.frustumCulled=!1,this.trails=null,this.version=-1}update(t){if(this.mesh.visible=t!==null&&!t.empty,!t||(t!==this.trails&&this.rebuild(t),t.version===this.version))return;this.version=t.version,this.uniforms.head.value=t.head;let e=this.uniforms.points.value;e&&(e.needsUpdate=!0)}rebuild(t){this.trails=t,this.version=-1;let e=t.nodes.length;this.uniforms.points.value?.dispose();let n=new Gi(t.points,360,e,Vn,Hn);n.internalFormat="RGBA32F",this.uniforms.points.value=n;let s=new Float32Array(6*360*e),r=[];for(let a=0;a<e;a++)for(let l=0;l<360;l++){let c=2*(a*360+l);s.set([...t.colours[a],...t.colours[a]],3*c),l<359&&r.push(c,c+1,c+2,c+1,c+3,c+2)}let o=new en;o.setAttribute("tint",new tn(s,3)),o.setIndex(r),this.mesh.geometry.dispose(),this.mesh.geometry=o}};var L3=[24e3,4e4],N3=[2400,2600],D3=.65,ed=class{constructor(t){let e=t.getContext("webgl2",{antialias:!1,alpha:!1,powerPreference:"high-performance"});if(!e)throw new Error("no WebGL2");this.name="webgl",this.canvas=t,this.three=new Wu({canvas:t,context:e,antialias:!1}),this.three.outputColorSpace=js,this.shared={view:{value:new Ge},projection:{value:new Ge},eye:{value:new J},up:{value:new J},right:{value:new J},key:{value:new J(0,0,1)},pixel:{value:.001},ratio:{value:1},coarse:{value:1}},this.scene=new as,this.scene.matrixWorldAutoUpdate=!1,this.camera=new Ur,this.soft=O3(e),this.line=new Mo(...this.soft?N3:L3),this.backdrop=new Ju(this.shared,this.soft),this.ribbons=new Qu(this.shared,this.backdrop),this.markers=new ju(this.shared),this.arrows=new ea(this.shared),this.touches=new ea(this.shared,!1,!0),this.posts=new ea(this.shared,!0),this.trails=new td(this.shared),this.scene.add(this.backdrop.mesh,this.backdrop.deep,this.ribbons.shadow,this.ribbons.contact,this.trails.mesh,this.ribbons.ropes,this.ribbons.dots,this.markers.points,this.arrows.mesh,this.touches.mesh,this.posts.mesh)}setShape(t){this.line.setShape(t)}setTheme(t){let e=new we().setRGB(...t.background,js);this.three.setClearColor(e,1),this.backdrop.setTheme(t),this.ribbons.setTheme(t)}resize(t,e,n){this.three.setPixelRatio(n),this.three.setSize(t,e,!1),this.shared.ratio.value=n,this.backdrop.resize(this.canvas.width,this.canvas.height)}draw(t){let{camera:e}=t;this.shared.view.value.fromArray(e.view),this.shared.projection.value.fromArray(e.projection),this.shared.eye.value.set(...e.eye),this.shared.up.value.set(...e.up),this.shared.right.value.set(...e.right),this.shared.pixel.value=1/e.focal,this.shared.key.value.set(...e.light),this.line.update(t)?this.ribbons.setLine(this.line):t.moved&&this.ribbons.moved();let n=this.ribbons.uniforms,s=.5*t.pixels*e.pose.distance/e.focal;Math.abs(Math.log2(s/n.thick.value))>D3&&(n.thick.value=s),n.range.value.set(t.range.low,t.range.high),n.plain.value=t.plain,n.least.value=t.pixels,n.height.value=t.ground.height,this.ribbons.shadow.visible=e.eyeHeight(t.ground.height)>0,this.ribbons.dots.visible=t.dots,this.ribbons.setSolid(t.solids.length>0),this.backdrop.update(this.three,this.camera,t),this.markers.update(t.markers),this.arrows.update(t.arrows,e.pose.distance/e.focal),this.touches.update(t.touches,e.pose.distance/e.focal),this.posts.update(t.posts,e.pose.distance/e.focal),this.trails.update(t.trails),this.three.render(this.scene,this.camera)}get rough(){return this.shared.coarse.value>1}get unfinished(){return this.backdrop.unfinished}clear(){this.three.clear()}dispose(){this.ribbons.dispose(),this.backdrop.dispose(),this.three.dispose()}};function O3(i){let t=i.getExtension("WEBGL_debug_renderer_info"),e=t?String(i.getParameter(t.UNMASKED_RENDERER_WEBGL)):"";return/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)}function E_(i){if(new URLSearchParams(location.search).get("renderer")!=="canvas")try{return new ed(i)}catch(e){console.info("Canvas 2D is used:",e);let n=i.cloneNode();return i.replaceWith(n),new Fa(n)}return new Fa(i)}var nd=class{constructor(){this.listeners=new Map}on(t,e){let n=this.listeners.get(t)??[];n.push(e),this.listeners.set(t,n)}emit(t,e){for(let n of this.listeners.get(t)??[])n(e)}};var id=class extends nd{constructor(t){super(),this.source=t,this.hello=null,this.layout=null,this.parameters=[],this.presets=[],this.status=null,this.stability=[],this.broken=null,this.frame=null,this.frames=0,this.connection="connecting",this.lastId=0,this.pendingFrame=-1,this.resting=!1,this.waiting=new Map}open(t=this.source){this.source=t,t.open({message:e=>this.take(e),frame:e=>this.takeFrame(e),state:(e,n)=>{if(this.connection=e,e!=="open"){let s={type:"error",text:"The server is not there."};for(let{reject:r}of this.waiting.values())r(s);this.waiting.clear()}this.emit("connection",{state:e,text:n})}})}get gone(){return["ended","lost","full"].includes(this.connection)}can(t){return this.hello?.can.includes(t)??!1}send(t){this.can(t.type)&&this.source.send(t)}ask(t){let e=++this.lastId;return new Promise((n,s)=>{if(!this.can(t.type)){s({type:"error",text:`This cannot be done here (${t.type})`});return}this.waiting.set(e,{resolve:n,reject:s}),this.source.send({...t,id:e})})}async tell(t){if(this.gone)return!1;try{return await this.ask(t),!0}catch(e){return this.emit("error",e),!1}}take(t){switch(t.type){case"hello":this.hello=t;break;case"layout":t.layout!==this.layout?.layout&&(this.frame=null),this.layout=t;break;case"obstacles":this.layout&&(this.layout.obstacles=t.obstacles);break;case"parameters":this.parameters=t.parameters,this.emit("parameters",this.parameters);return;case"presets":this.presets=t.presets,this.emit("presets",this.presets);return;case"status":this.status=t,!t.broken&&this.broken&&(this.broken=null,this.emit("broken",null));break;case"stability":this.stability=t.variants,this.emit("stability",this.stability);return;case"broken":this.broken=t;break;case"done":case"error":this.answer(t);return}this.emit(t.type,t)}answer(t){let e=this.waiting.get(t.id);this.waiting.delete(t.id),t.type==="done"?e?.resolve(t):e?e.reject(t):this.emit("error",t)}takeFrame(t){if(this.pendingFrame=km(t),!this.layout||Bs(t)!==this.layout.layout){this.acknowledge();return}let e=this.frame;this.frame=ur(t,this.layout),this.frames++,this.emit("frame",this.frame),e&&Bm(e)}acknowledge(){this.resting=!this.resting,!(this.pendingFrame<0||this.resting)&&(this.source.used(this.pendingFrame),this.pendingFrame=-1)}};function T_(i){let t=atob(i.trim()),e=new Uint8Array(t.length);for(let n=0;n<t.length;n++)e[n]=t.charCodeAt(n);return e}async function A_(i){let t=new Blob([i]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(t).arrayBuffer())}function R_({columns:i,low:t,step:e,order:n,planes:s},r,o){let a=r*i;if(o.length!==a*s)throw new Error("the recording is damaged");let l=new Int32Array(a);for(let c=0;c<i;c++){let h=0,u=0;for(let d=c*r;d<(c+1)*r;d++){let f=o[d];for(let x=1;x<s;x++)f|=o[x*a+d]<<8*x;let p=f>>>1^-(f&1);n===2?h+=u+=p:h+=p,l[d]=h}}return{columns:i,rows:r,low:t,step:e,whole:l}}function ar({columns:i,rows:t,low:e,step:n,whole:s},r,o){for(let a=0;a<i;a++)o[a]=e[a]+n[a]*s[a*t+r];return o}var k3=48,B3=600,C_=40;function P_(){let i=document.getElementById("recording"),t=document.getElementById("recording-data");if(!i||!t)return null;let e=JSON.parse(i.textContent??""),n=new gm(e,t.textContent??"");return{replay:new Rr(H3(e),{...e,playing:!0},n),about:e.about}}var z3=[["contact",0],["rope_contacts",-1],["wraps",-1],["friction_work",NaN]];function H3({ropewalk:i,title:t}){return{type:"hello",protocol:1,ropewalk:i,client:0,mode:"replay",can:[],limits:{},title:t,folder:null,address:"",speeds:[.01,4],grabs:0,exports:[]}}var gm=class{constructor(t,e){this.base="",this.within=1e-6,this.header=t,this.text=e,this.parts=[],this.clock=new Float64Array(0)}async times(){return await this.load(),this.clock}async layout(t){return this.parts[t].layout}take(t,e){return this.frame(t,e)}async read(t,e,n){let s=[];for(let r=0;r<e&&t+r*n<this.clock.length;r++)s.push(this.frame(t+r*n,t+(r-1)*n)),r%C_===C_-1&&await new Promise(o=>setTimeout(o));return s}async load(){let t=T_(this.text);this.text="";let e=0,n=async(c,h)=>{let u=t.slice(e,e+=c.bytes);return R_(c,h,await A_(u))},{parts:s,times:r}=this.header,o=s.reduce((c,h)=>c+h.frames,0),a=await n(r,o);this.clock=Float64Array.from(a.whole,c=>r.low[0]+r.step[0]*c);let l=0;for(let c of s){let h={};for(let f of c.streams)h[f.name]=await n(f,c.frames);let{layout:u,good:d}=c;this.parts.push({layout:u,first:l,frames:c.frames,good:d,numbers:h}),l+=c.frames}}partOf(t){return this.parts.findIndex(({first:e,frames:n})=>t<e+n)}frame(t,e=t-1){let{layout:n,first:s,good:r,numbers:o}=this.parts[this.partOf(t)],a=t-s,[l]=n.variants,{offsets:c,nodes:h,anchors:u}=l,d=new ArrayBuffer(n.bytes),f=new DataView(d,0,k3),p=(t===this.clock.length-1?16:0)|(a>=r?2:0);[1179670354,n.layout,0,p].forEach(($,k)=>f.setUint32(4*k,$,!0)),f.setFloat64(16,this.clock[t],!0),f.setFloat64(24,t,!0);let x=($,k)=>new Float32Array(d,$,k),g=ar(o.scalars,a,x(c.scalars,n.scalars.length)),m=ar(o.positions,a,x(c.positions,3*h)),v=($,k)=>{let ot=n.scalars.indexOf($);ot>=0&&(g[ot]=k)},M=Math.max(e-s+1,a-B3,0),w=W3(o,Math.min(M,a),a),R=$=>new Uint16Array(d,$,h),T=Object.fromEntries(n.scalars.map(($,k)=>[$,k]));for(let $=M;$<a;$++){let k=ar(o.scalars,$,new Float64Array(n.scalars.length));g[T.tension_max]=Math.max(g[T.tension_max],k[T.tension_max]),g[T.high]=Math.max(g[T.high],k[T.high]),g[T.low]=Math.min(g[T.low],k[T.low])}let y=[w.leastTension,w.greatestTension,w.tension],[A,U]=I_(y);na(w.tension,A,U,R(c.tension)),na(w.leastTension,A,U,R(c.least_tension)),na(w.greatestTension,A,U,R(c.greatest_tension)),v("tension_low",A),v("tension_high",U);let N=I_([w.greatestSpeed,w.speed])[1];na(w.speed,0,N,R(c.speed)),na(w.greatestSpeed,0,N,R(c.greatest_speed)),v("speed_high",N);let P=Float64Array.from({length:h},($,k)=>n.up.reduce((ot,K,Q)=>ot+K*m[3*k+Q],0));for(let $ of[c.least_height,c.greatest_height])na(P,g[T.low],g[T.high],R($));x(c.greatest_force,u.length).set(w.greatestForce);let G=ar(o.velocity,a,new Float32Array(3*u.length)),W=ar(o.force,a,new Float32Array(3*u.length)),D=x(c.anchors,10*u.length);u.forEach(({index:$,until:k},ot)=>{D.set(m.subarray(3*$,3*$+3),10*ot),D.set(G.subarray(3*ot,3*ot+3),10*ot+3),D.set(W.subarray(3*ot,3*ot+3),10*ot+6),D[10*ot+9]=G3(k,this.clock[t])?1:0}),V3(o,a<r?a:-1,d,c);let V=x(c.grabs,Math.floor((n.bytes-c.grabs)/4));for(let $=0;$<V.length;$+=8)V[$]=-1;return d}};function V3(i,t,e,n){for(let[s,r]of z3){let o=to(e,n,s).fill(r);t>=0&&i[s]&&o.length&&ar(i[s],t,o)}}var G3=(i,t=0)=>i==null||t<i;function W3(i,t,e){let n=(a,l)=>ar(i[a],l,new Float64Array(i[a].columns)),s=(a,l,c)=>{let h=new Float64Array(i[a].columns).fill(-c*(1/0));for(let u=t;u<=e;u++){let[d,f]=[n(a,u),n(l,u)];d.forEach((p,x)=>{let g=p+c*f[x];c*g>c*h[x]&&(h[x]=g)})}return h},r=i.greatest_force.columns,o=new Float64Array(r);for(let a=t;a<=e;a++){let[l,c]=[n("force",a),n("greatest_force",a)];o.forEach((h,u)=>{let d=Math.hypot(...l.subarray(3*u,3*u+3))+c[u];o[u]=Math.max(h,d)})}return{tension:n("tension",e),speed:n("speed",e),leastTension:s("tension","least_tension",-1),greatestTension:s("tension","greatest_tension",1),greatestSpeed:s("speed","greatest_speed",1),greatestForce:o}}function I_(i){let[t,e]=[0,1e-30];for(let n of i)for(let s of n)s<t&&(t=s),s>e&&(e=s);return[t,e]}function na(i,t,e,n){let s=65535/Math.max(e-t,1e-30);for(let r=0;r<i.length;r++)n[r]=Math.min(65535,Math.max(0,(i[r]-t)*s+.5))}var sd=(i,t)=>t<i||i!==i?t:i,ds=(i,t)=>t>i||i!==i?t:i,$3=[["tension_low",sd],["tension_high",ds],["tension_max",ds],["speed_high",ds],["low",sd],["high",ds]];function L_(i,t,e){if(!e||Bs(i)!==Bs(t))return;let n=ur(i,e).parts;ur(t,e).parts.forEach((s,r)=>X3(e,n[r],s))}function X3(i,t,e){let n={...e,scalars:e.scalars.slice()};for(let[a,l]of $3){let c=i.scalars.indexOf(a);c>=0&&(e.scalars[c]=l(n.scalars[c],t.scalars[c]))}let s=(a,l,c)=>[l===null?0:Be(i,a,l),Be(i,a,c)],r=(a,l,c,h,u)=>{let[[d,f],[p,x],[g,m]]=[n,t,e].map(M=>s(M,h,u)),v=65535/Math.max(m-g,1e-30);for(let M=0;M<a.length;M++){let w=d+a[M]/65535*(f-d);l&&(w=c(w,p+l[M]/65535*(x-p))),a[M]=Math.min(65535,Math.max(0,(w-g)*v+.5))}},{seen:o}=e;r(e.tension,null,ds,"tension_low","tension_high"),r(e.speed,null,ds,null,"speed_high"),r(o.leastTension,t.seen.leastTension,sd,"tension_low","tension_high"),r(o.greatestTension,t.seen.greatestTension,ds,"tension_low","tension_high"),r(o.greatestSpeed,t.seen.greatestSpeed,ds,null,"speed_high"),r(o.leastHeight,t.seen.leastHeight,sd,"low","high"),r(o.greatestHeight,t.seen.greatestHeight,ds,"low","high"),o.greatestForce.forEach((a,l)=>{o.greatestForce[l]=ds(a,t.seen.greatestForce[l])})}var N_=64e6,q3=2e6,Y3=64,K3=16,Z3=1e3,rd=class{constructor(t,e){this.base=t,this.fail=e,this.within=1e-9,this.count=0,this.loading=!1,this.failed=-1/0,this.said="",this.held=0,this.kept=new Map,this.layouts=new Map,this.written=new Map,this.bytes=1}async times(){let t=new Float64Array(await(await this.fetch("times.bin")).arrayBuffer());return this.count=t.length,t}layout(t){let e=this.layouts.get(t);if(e)return e;let n=this.fetch(`layout.json?part=${t}`).then(s=>s.json());return n.catch(()=>this.layouts.delete(t)),this.layouts.set(t,n),n}take(t,e,n,s){let r=(t-e)/n,o=Number.isInteger(r)&&r<=Math.min(K3,N_/4/this.bytes),a=s&&o?n:t-e,l=null;for(let c=e+a;c<=t;c+=a){let h=this.kept.get(`${c} ${a}`);if(!h)return this.load(c,a,s&&a===n?this.piece:1),null;let u=h.slice(0);l&&L_(l,u,this.written.get(Bs(u))),l=u}return s&&a===n&&this.ahead(t,a),l}get piece(){return Math.min(Y3,Math.max(2,Math.floor(q3/this.bytes)))}ahead(t,e){let{piece:n}=this,s=0;for(;s<n&&this.kept.has(`${t+(s+1)*e} ${e}`);)s++;let r=t+(s+1)*e;s<n/2&&r<this.count&&this.load(r,e,n)}async load(t,e,n){if(!(this.loading||performance.now()<this.failed+Z3)){this.loading=!0;try{(await this.read(t,n,e)).forEach((s,r)=>this.keep(`${t+r*e} ${e}`,s))}catch(s){this.failed=performance.now();let r=s instanceof TypeError?"":Ca(s);r&&r!==this.said&&this.fail(r),this.said=r}finally{this.loading=!1}}}keep(t,e){this.held+=e.byteLength-(this.kept.get(t)?.byteLength??0),this.kept.delete(t),this.kept.set(t,e);for(let[n,{byteLength:s}]of this.kept){if(this.held<=N_||this.kept.size<=4)return;this.kept.delete(n),this.held-=s}}async read(t,e,n,s){let r=`frames.bin?first=${t}&count=${e}&every=${n}`,o=await(await this.fetch(r,s)).arrayBuffer(),a=[];for(let l=0;l<o.byteLength;l+=this.bytes){let c=Bs(o.slice(l,l+48)),h=await this.layout(c-1);if(this.written.set(c,h),this.bytes=h.bytes,l+this.bytes>o.byteLength)throw new Error("the server's answer is cut short");a.push(o.slice(l,l+this.bytes))}return a}async fetch(t,e){let n=await fetch(`${this.base}replay/${t}`,{signal:e});if(!n.ok)throw new Error((await n.text()).trim());return n}};var xm=[500,1e3,2e3],J3=1e3,j3=4503,Q3=[1e3,1001,1012],od=class{constructor(){this.base="./",this.socket=null,this.tries=0,this.ending="",this.goesOn=!0,this.events=null}open(t){this.events=t,this.connect()}connect(){let t=this.events,e=new URL("socket",location.href.split(/[?#]/)[0]);e.protocol=e.protocol.replace("http","ws");let n=new WebSocket(e,"ropewalk.1");n.binaryType="arraybuffer",this.socket=n,setTimeout(()=>{n.readyState===WebSocket.CONNECTING&&t.state("waiting","Setting up the simulation; its first run takes a minute or two …")},J3);let s=!1;n.onopen=()=>{s=!0,t.state("open","")},n.onmessage=({data:r})=>{if(typeof r!="string"){t.frame(r);return}let o=JSON.parse(r);o.type==="hello"&&([this.tries,this.ending]=[0,""],this.goesOn=o.mode!=="replay"),o.type==="bye"&&(this.ending=o.text),t.message(o)},n.onclose=({code:r,reason:o})=>{if(this.socket!==n)return;let a=this.ending?xm[2]:xm[Math.min(this.tries++,xm.length-1)];if(Q3.includes(r)&&(this.ending||="The server has ended."),r===j3)t.state("full",o||"As many pages as allowed are open.");else if(this.ending)t.state("ended",this.ending);else if(r===4400||r===4429||r===1009)t.state("lost",`The server closed the connection: ${o||r}.`);else if(s){let l=this.goesOn?"; the run goes on there":"";t.state("lost",`The connection to the server is lost${l}.`)}else t.state("lost","The server does not answer: it has ended, or is out of reach.");setTimeout(()=>this.connect(),a)}}send(t){this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify(t))}used(t){this.send({type:"ack",frame:t})}};Cc(Rx());var ad=P_(),Vr=new id(ad?.replay??new od),tI=document.getElementById("app"),ld=new Kc(tI,Vr,E_);ad?(kf(ld,ad.replay),ld.help.window.append(z("p",{className:"faint",id:"about"},ad.about))):Vr.on("replay",i=>eI(i));Object.assign(window,{ropewalk:qx(ld)});Vr.open();function eI(i){let{hello:t,source:e}=Vr;if(e instanceof Rr)return Vr.take(e.hello);if(!t)return;let n=new rd(e.base,r=>Vr.take({type:"error",text:r})),s=new Rr(t,i,n);kf(ld,s),Vr.open(s)}})();
