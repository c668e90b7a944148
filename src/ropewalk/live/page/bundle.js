"use strict";(()=>{var fn=n=>[n[0],n[1],n[2]],Pi=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Po=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],pn=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],ve=(n,t,e=1)=>[n[0]+e*t[0],n[1]+e*t[1],n[2]+e*t[2]],ci=(n,t)=>[n[0]*t,n[1]*t,n[2]*t],Cr=n=>Math.hypot(n[0],n[1],n[2]);function Gh(n,t=[0,0,1]){let e=Cr(n);return e>0?ci(n,1/e):t}var c_=3,Wh=[["ArrowLeft","ArrowRight","ArrowUp","ArrowDown","Home","End"],["KeyA","KeyD","KeyW","KeyS","KeyQ","KeyE"],["KeyJ","KeyL","KeyI","KeyK","KeyU","KeyO"]],Fa=class{constructor(t,e,i){this.session=t,this.camera=e,this.shortcuts=i,this.held=new Set,this.moving=new Map,addEventListener("keydown",s=>this.press(s)),addEventListener("keyup",s=>this.lift(s.code)),addEventListener("blur",()=>this.releaseAll()),document.addEventListener("visibilitychange",()=>{document.hidden&&this.releaseAll()}),document.addEventListener("click",h_),t.on("connection",()=>this.forget())}press(t){if(t.ctrlKey||t.metaKey||t.altKey||u_(t))return;let e=Wh.findIndex(s=>s.includes(t.code));if(e>=0&&this.anchor(e)!==null&&this.session.can("move")){if(t.preventDefault(),t.repeat||this.held.has(t.code))return;this.held.add(t.code),this.sendHand(e);return}let i=this.shortcuts[t.key.toLowerCase()];i&&(t.key===" "&&d_(t.target)||(t.preventDefault(),(!t.repeat||t.key===".")&&i()))}lift(t){this.held.delete(t)&&this.sendHand(Wh.findIndex(e=>e.includes(t)))}releaseAll(){this.held.clear();for(let t of[...this.moving.keys()])this.sendHand(t)}forget(){this.held.clear(),this.moving.clear()}anchor(t){let e=this.session.layout?.variants[0].anchors??[],i=this.session.frame?.parts[0];return e.filter((r,o)=>!i||i.anchors[10*o+9]>.5)[t]?.name??null}sendHand(t){let e=Wh[t].map(g=>this.held.has(g)?1:0),i=this.moving.get(t)??this.anchor(t);if(i===null)return;let[s,r,o,a,c,l]=e,{camera:h}=this,u=ci(h.first,r-s);u=ve(u,h.up,o-a),u=ve(u,h.second,c-l);let d=Cr(u),f=d>0?ci(u,c_/d):[0,0,0];d>0?this.moving.set(t,i):this.moving.delete(t),this.session.send({type:"move",anchor:i,velocity:f})}};function h_(n){let{target:t}=n;if(n.detail===0||!(t instanceof Element))return;t instanceof HTMLInputElement&&["range","checkbox"].includes(t.type)?t.blur():t.closest("button")?.blur()}function u_({target:n,code:t}){return n instanceof HTMLElement?n instanceof HTMLInputElement?n.type==="range"?/^(Arrow|Page|Home|End)/.test(t):!["checkbox","radio","button"].includes(n.type):n.isContentEditable||["SELECT","TEXTAREA"].includes(n.tagName):!1}function d_(n){return n instanceof HTMLElement&&n.closest("button, summary, [role=menuitem]")!==null}var Io=class{constructor(){this.low=0,this.high=1,this.fresh=!0}follow(t,e,i){if(!Number.isFinite(t)||!Number.isFinite(e))return;let s=t<-.01*e?t:0,r=Math.max(e,s+1e-9);if(this.fresh){[this.low,this.high,this.fresh]=[s,r,!1];return}let o=1-Math.exp(-i/4);this.high=r>this.high?r:this.high+o*(Math.max(r,1e-9)-this.high),this.low=s<this.low?s:this.low+o*(s-this.low)}},Pf=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"]],f_=new Set(["N","J","W","s","Hz","N/m","m","m/s","N s/m"]),Pr=n=>n==="1"?"":n.replace(/\^2/g,"²").replace(/\^3/g,"³");function gi(n,t=""){if(n==null||Number.isNaN(n))return"–";if(!Number.isFinite(n))return n>0?"∞":"−∞";let e=t&&t!=="1"?` ${Pr(t)}`:"";if(n===0)return`0${e}`;let i=Math.abs(n);if(f_.has(t)&&(i>=1e4||i<.1)&&i>=1e-9){let s=t==="m"||t==="m/s"?1:1e10,[r,o]=Pf.find(([a])=>i>=a*.9995&&a<=s)??Pf[6];return`${Xe(n/r)} ${o}${t}`}return`${Xe(n)}${e}`}function Xe(n){let t=Math.abs(n);if(t>=1e5||t<.001){if(n===0)return"0";let[i,s]=n.toExponential(2).split("e");return`${Number(i)}e${Number(s)}`.replace("-","−")}let e=Math.max(0,2-Math.floor(Math.log10(t)));return String(Number(n.toFixed(Math.min(6,e)))).replace("-","−")}function If(n){let t=10**Math.floor(Math.log10(n)),e=n/t;return t*(e<1.5?1:e<3.5?2:e<7.5?5:10)}var p_=8,m_=.05,Lo=class{constructor(t,e,i){this.stage=t,this.hit=e,this.way=i,this.place=e.place,this.sent=-1/0,this.pending=0}moveTo(t,e){let{stage:i,hit:s}=this;if(this.place=i.camera.inPlane(t,e,s.place),this.way==="kick"){let o=`${Xe(Cr(this.velocity()))} m/s`;i.marks.kick={from:s.place,to:this.place,text:o},i.marks.dirty=!0;return}let r=this.sent+p_-performance.now();r<=0?this.sendTarget():this.pending||=window.setTimeout(()=>this.sendTarget(),r)}sendTarget(){if(clearTimeout(this.pending),this.pending=0,this.over)return;this.sent=performance.now();let t=pn(this.place,this.stage.shifts[this.hit.variant]),{session:e}=this.stage;this.hit.kind==="anchor"?e.send({type:"drag",anchor:this.hit.anchor,target:t}):e.send({type:"grab",node:this.hit.node,target:t})}velocity(){let{camera:t}=this.stage,e=t.pose.distance/t.focal;return ci(pn(this.place,this.hit.place),m_/e)}release(t){let{session:e,marks:i}=this.stage;if(this.way==="kick"){i.kick=null,i.dirty=!0;let s=this.velocity();Cr(s)>.05&&e.tell({type:"kick",node:this.hit.node,velocity:s})}else this.hit.kind==="anchor"?(this.sendTarget(),e.send({type:"drop",anchor:this.hit.anchor})):t?this.sendTarget():e.send({type:"let_go",node:this.hit.node});this.over=!0}over=!1;get ring(){return ve(this.place,[0,0,0])}};function Xh(n,t,e,i){return g_(n,t,e,i*1.3)??__(n,t,e,i)}function g_(n,t,e,i){let{layout:s,frame:r}=n.session;if(!s||!r)return null;let o=null,a=i,c=0;return s.variants.forEach((l,h)=>{l.anchors.forEach((u,d)=>{let f=fn(n.anchors.shown.subarray(c,c+3));if(c+=3,r.parts[h].anchors[10*d+9]<.5)return;let[g,y,m]=n.camera.project(...f),p=Math.hypot(g-t,y-e);if(m<=0||p>=a)return;a=p;let v=Math.min(u.index,l.nodes-2);o={kind:"anchor",variant:h,anchor:u.name,node:u.index,segment:v,place:f}})}),o}function __(n,t,e,i){let{layout:s}=n.session;if(!s)return null;let{shown:r}=n.nodes,o=null,a=i;return s.variants.forEach((c,l)=>{for(let h of c.ropes){let[u,d,f]=[0,0,!0];for(let g=h.first;g<h.first+h.nodes;g++){let y=4*(n.starts[l]+g),[m,p,v]=n.camera.project(r[y],r[y+1],r[y+2]);if(g>h.first&&!f&&v>0){let[A,S]=x_(t,e,u,d,m,p);if(A<a){a=A;let C=S>.5?g:g-1,T=4*(n.starts[l]+C),x=fn(r.subarray(T,T+3));o={kind:"node",variant:l,rope:h.name,node:C,segment:g-1,place:x}}}[u,d,f]=[m,p,v<=0]}}}),o}function x_(n,t,e,i,s,r){let[o,a]=[s-e,r-i],c=o*o+a*a,l=c>0?Math.min(1,Math.max(0,((n-e)*o+(t-i)*a)/c)):0;return[Math.hypot(n-e-l*o,t-i-l*a),l]}var v_=5,y_=550,M_=350,Ua=class{constructor(t,e,i){this.stage=t,this.element=e,this.actions=i,this.tool="hand",this.keep=!1,this.down=new Map,this.hand=null,this.hit=null,this.start=null,this.moved=!1,this.lastClick=0,this.longPress=0,this.menuOpened=!1,this.hovering=!1,e.addEventListener("pointerdown",s=>this.press(s)),e.addEventListener("pointermove",s=>this.move(s)),e.addEventListener("pointerrawupdate",s=>this.drag(s)),e.addEventListener("pointerup",s=>this.lift(s)),e.addEventListener("pointercancel",s=>this.lift(s)),e.addEventListener("pointerleave",()=>this.hover(null)),e.addEventListener("wheel",s=>this.wheel(s),{passive:!1}),e.addEventListener("contextmenu",s=>s.preventDefault())}at(t){let e=this.element.getBoundingClientRect();return{x:t.clientX-e.left,y:t.clientY-e.top}}reach(t){return t.pointerType==="mouse"?11:24}press(t){this.element.setPointerCapture(t.pointerId);let{x:e,y:i}=this.at(t);if(this.down.set(t.pointerId,{x:e,y:i}),this.stage.flight=null,this.down.size>1){clearTimeout(this.longPress),this.dropHand(!1),this.moved=!0;return}if(this.start={x:e,y:i,button:t.button,shift:t.shiftKey},this.moved=this.menuOpened=!1,this.hit=Xh(this.stage,e,i,this.reach(t)),t.button===0&&this.hit&&!(t.ctrlKey||t.metaKey))if(this.tool==="hand"){let s=this.hit.kind==="anchor"?"drag":"grab";this.stage.session.can(s)&&(this.hand=new Lo(this.stage,this.hit,s))}else this.tool==="kick"&&(this.hand=new Lo(this.stage,this.hit,"kick"));t.pointerType!=="mouse"&&(this.longPress=window.setTimeout(()=>this.openMenu(e,i),y_))}move(t){let{x:e,y:i}=this.at(t),s=this.down.get(t.pointerId);if(!s){t.pointerType==="mouse"&&this.hover(Xh(this.stage,e,i,11));return}if(this.down.size===2){this.pinch(t.pointerId,e,i);return}let{start:r}=this;if(!r||!this.moved&&Math.hypot(e-r.x,i-r.y)<v_)return;this.moved=!0,clearTimeout(this.longPress);let[o,a]=[e-s.x,i-s.y];this.down.set(t.pointerId,{x:e,y:i}),!this.menuOpened&&(this.hand?(this.hand.moveTo(e,i),this.stage.marks.hover=this.hand.way==="kick"?null:this.hand.ring,this.stage.marks.dirty=!0):r.button!==0||r.shift?this.stage.camera.pan(o,a):this.stage.camera.orbit(o,a))}drag(t){if(!this.hand||!this.moved||this.menuOpened||this.down.size!==1)return;let{x:e,y:i}=this.at(t);this.hand.moveTo(e,i)}lift(t){if(!this.down.delete(t.pointerId))return;clearTimeout(this.longPress);let{x:e,y:i}=this.at(t);this.hand&&this.moved&&this.hand.moveTo(e,i);let s=this.hand!==null&&this.moved;this.dropHand(t.shiftKey||this.keep,this.moved),!(this.moved||this.menuOpened||s||this.down.size)&&(t.button===2?this.openMenu(e,i):t.button===0&&this.click(t.timeStamp))}click(t){if(this.hit&&this.tool!=="hand"&&this.tool!=="kick"){this.actions.use(this.tool,this.hit);return}this.hit||(t-this.lastClick<M_&&this.letGo(),this.lastClick=t)}letGo(){this.stage.session.send({type:"let_go"})}openMenu(t,e){this.menuOpened=!0,this.dropHand(!1,!1),this.actions.menu(this.hit,t,e)}dropHand(t,e=!0){let{hand:i}=this;this.hand=null,i&&e&&i.release(t),i&&this.hover(null)}pinch(t,e,i){let s=[...this.down.entries()].find(([c])=>c!==t)?.[1],r=this.down.get(t);if(!s||!r)return;let[o,a]=[r,{x:e,y:i}].map(c=>Math.hypot(c.x-s.x,c.y-s.y));this.stage.camera.pan((e-r.x)/2,(i-r.y)/2),a>1&&this.stage.camera.zoom(o/a,(e+s.x)/2,(i+s.y)/2),this.down.set(t,{x:e,y:i})}wheel(t){t.preventDefault();let{x:e,y:i}=this.at(t),s=t.deltaMode===1?18:1;this.stage.flight=null,this.stage.camera.zoom(Math.exp(Math.max(-60,Math.min(60,t.deltaY*s))*.003),e,i)}hover(t){let{marks:e}=this.stage,i=t?.place??null;i===null&&e.hover===null||(e.hover=i,e.dirty=!0,this.element.classList.toggle("over",i!==null))}};var Qe=["#3b8bc4","#d9652b","#1f9e77","#c879a7","#d99a1c","#5ab4e0","#8a8f98"];var $h=[[.46,.15,268],[.53,.17,305],[.6,.19,350],[.68,.17,30],[.76,.155,62],[.84,.155,88]],S_=(n,t,e)=>{let i=e*Math.PI/180;return[n,t*Math.cos(i),t*Math.sin(i)]};function b_([n,t,e]){let i=(n+.3963377774*t+.2158037573*e)**3,s=(n-.1055613458*t-.0638541728*e)**3,r=(n-.0894841775*t-1.291485548*e)**3;return[4.0767416621*i-3.3077115913*s+.2309699292*r,-1.2684380046*i+2.6097574011*s-.3413193965*r,-.0041960863*i-.7034186147*s+1.707614701*r]}var w_=n=>{let t=Math.min(1,Math.max(0,n));return t<=.0031308?12.92*t:1.055*t**(1/2.4)-.055};function Ir(){let n=[],t=$h.length-1;for(let r=0;r<=4e3;r++){let o=r/4e3*t,a=Math.min(t-1,Math.floor(o)),c=o-a,[l,h]=[$h[a],$h[a+1]],u=h[2]-l[2];u<-180&&(u+=360);let d=l[2]+c*u;n.push(S_(l[0]+c*(h[0]-l[0]),l[1]+c*(h[1]-l[1]),d))}let e=[0];for(let r=1;r<n.length;r++){let[o,a]=[n[r-1],n[r]];e.push(e[r-1]+Math.hypot(a[0]-o[0],a[1]-o[1],a[2]-o[2]))}let i=[],s=0;for(let r=0;r<256;r++){let o=e[e.length-1]*r/255;for(;s<e.length-1&&e[s]<o;)s++;i.push(b_(n[s]).map(w_))}return i}function qs(n){let t=parseInt(n.slice(1),16);return[(t>>16&255)/255,(t>>8&255)/255,(t&255)/255]}function hi(n,t=1){let[e,i,s]=[0,1,2].map(r=>Math.round(255*n[r]));return t<1?`rgba(${e}, ${i}, ${s}, ${t})`:`rgb(${e}, ${i}, ${s})`}function X(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))r!=null&&(s.startsWith("on")?i.addEventListener(s.slice(2),r):s.includes("-")||s==="role"||s==="for"?i.setAttribute(s,String(r)):s==="data"?Object.assign(i.dataset,r):Object.assign(i,{[s]:r}));for(let s of e)s&&i.append(s);return i}var Lf="http://www.w3.org/2000/svg",E_={play:"M8 5.5v13l10.5-6.5z",pause:"M8 5v14M16 5v14",step:"M6 5.5v13l9-6.5zM18.5 5v14",reset:"M5 12a7 7 0 1 0 2.3-5.2M5 4.5v4.2h4.2",fit:"M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5",hand:"M8.5 12V6.2a1.4 1.4 0 0 1 2.8 0V11M11.3 10V4.9a1.4 1.4 0 0 1 2.8 0V11M14.1 10.5V6.3a1.4 1.4 0 0 1 2.8 0V14c0 4-2 6.5-5.3 6.5-3 0-4.3-1.5-5.8-4.2L4 13.2c-.8-1.5 1.1-2.6 2.2-1.3l2.3 2.6",pin:"M9 3.5h6M10 3.5l-.6 6.2L6.5 13h11l-2.9-3.3L14 3.5M12 13v7.5",cut:"M6.5 19.5a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4zM17.5 19.5a2.2 2.2 0 1 0 0-4.4 2.2 2.2 0 0 0 0 4.4zM8 15.5L16.5 4M16 15.5L7.5 4",load:"M12 3v5M12 8a1.5 1.5 0 0 0 0 0M7.5 10h9l2.5 10H5z",kick:"M4 12h13M12 6l6 6-6 6",follow:"M4 18c3-9 6 1 9-6 2-4.5 4-4 7-6",graph:"M4 4v16h16M7.5 15l3.5-5 3.5 3 5-7.5",scenes:"M4 5.5h7v5.5H4zM13.5 5.5H20v5.5h-6.5zM4 13.5h7V19H4zM13.5 13.5H20V19h-6.5z",tour:"M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18zM15.8 8.2l-2.3 5.3-5.3 2.3 2.3-5.3z",compare:"M12 3.5v17M4 6.5h5v11H4zM15 6.5h5v11h-5z",keep:"M12 4v10.5M7.5 10.5L12 15l4.5-4.5M4.5 16v3.5h15V16",help:"M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18zM9.5 9.5a2.6 2.6 0 1 1 3.6 2.4c-.8.4-1.1.9-1.1 1.8M12 16.8v.2",theme:"M12 20.5a8.5 8.5 0 1 0 0-17zM12 20.5a8.5 8.5 0 0 1 0-17",panel:"M4 7h9M17 7h3M15 5v4M4 12h3M11 12h9M9 10v4M4 17h11M19 17h1M17 15v4",close:"M6 6l12 12M18 6L6 18",down:"M6 9.5l6 6 6-6",link:"M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-1 1M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l1-1",undo:"M8.5 6L4.5 10l4 4M4.5 10h9a5.5 5.5 0 0 1 0 11h-2"};function mn(n,t=!1){let e=document.createElementNS(Lf,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true"),e.classList.add("icon"),t&&e.classList.add("solid");let i=document.createElementNS(Lf,"path");return i.setAttribute("d",E_[n]),e.append(i),e}function Ni(n,t,e,i={}){let s=i.key?`${t} (${i.key})`:t;return X("button",{type:"button",title:s,"aria-label":t,onclick:e,id:i.id??"",className:i.kind??"plain"},mn(n,n==="play"),i.words&&X("span",{className:"words"},i.words))}function Lr(n,t,...e){let i=X("button",{type:"button",className:"plain close","aria-label":"Close",title:"Close"},mn("close")),s=X("dialog",{className:`window ${t}`,"aria-label":n},X("header",{},X("h2",{},n),i),...e);return i.onclick=()=>s.close(),s.addEventListener("close",()=>{document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),s.addEventListener("click",r=>{r.target===s&&s.close()}),s}function No(n,t,e,i,s=""){n.querySelector(".popup")?.remove();let r=X("div",{className:"popup",role:"menu"},s&&X("div",{className:"popup-title"},s)),o=()=>{r.remove(),removeEventListener("pointerdown",a,!0),removeEventListener("keydown",c,!0)},a=h=>{r.contains(h.target)||o()},c=h=>{h.key==="Escape"&&o()};for(let h of i){let u=()=>{o(),h.press()};r.append(X("button",{type:"button",role:"menuitem",onclick:u,disabled:h.disabled??!1,id:h.id??""},h.label,h.hint&&X("small",{},h.hint)))}n.append(r);let l=n.getBoundingClientRect();return r.style.left=`${Math.max(4,Math.min(t,l.width-r.offsetWidth-4))}px`,r.style.top=`${Math.max(4,Math.min(e,l.height-r.offsetHeight-4))}px`,addEventListener("pointerdown",a,!0),addEventListener("keydown",c,!0),r.querySelector("button")?.focus({preventScroll:!0}),r}function qh(n,t){let e=X("a",{href:n,download:t});document.body.append(e),e.click(),e.remove()}var Oa=n=>new DataView(n).getUint32(4,!0),Nf=n=>new DataView(n).getUint32(8,!0);function Nr(n,t){let e=new DataView(n);if(e.byteLength<48||e.getUint32(0,!0)!==1179670354)throw new Error("not a frame");if(e.getUint32(4,!0)!==t.layout)throw new Error("a frame of another layout");if(n.byteLength<t.bytes)throw new Error("a frame cut short");return{layout:t.layout,number:e.getUint32(8,!0),flags:e.getUint32(12,!0),time:e.getFloat64(16,!0),steps:e.getFloat64(24,!0),realtime:e.getFloat32(32,!0),speed:e.getFloat32(36,!0),load:e.getFloat32(40,!0),parts:t.variants.map((i,s)=>T_(n,t,i,s))}}function Df(n){n.parts[0]?.scalars.buffer?.transfer?.(0)}function T_(n,t,e,i){let{offsets:s,nodes:r,anchors:o}=e,a=t.variants[i+1]?.offsets.scalars??t.bytes;return{scalars:new Float32Array(n,s.scalars,t.scalars.length),positions:new Float32Array(n,s.positions,3*r),tension:new Uint16Array(n,s.tension,r),speed:new Uint16Array(n,s.speed,r),anchors:new Float32Array(n,s.anchors,10*o.length),grabs:new Float32Array(n,s.grabs,8*Math.floor((a-s.grabs)/32))}}function gn(n,t,e){let i=n.scalars.indexOf(e);return i<0?NaN:t.scalars[i]}function Ff(n,t,e){let i=gn(n,t,"tension_low"),s=gn(n,t,"tension_high");return i+t.tension[e]/65535*(s-i)}var ka=class{constructor(){this.count=0,this.start=0,this.time=new Float64Array(2*7200),this.columns=new Map}clear(){this.count=this.start=0,this.columns.clear()}add(t,e){if(this.count>0&&t<=this.last){if(t===this.last)return;this.count=this.search(t)}if(this.start+this.count===2*7200){for(let s of[this.time,...this.columns.values()])s.copyWithin(0,this.start+1);this.start=0,this.count=7199}let i=this.start+this.count;this.time[i]=t;for(let s of this.columns.values())s[i]=NaN;for(let[s,r]of e){let o=this.columns.get(s);o||(o=new Float64Array(2*7200).fill(NaN),this.columns.set(s,o)),o[i]=r}this.count++,this.count>7200&&(this.count=7200,this.start++)}get last(){return this.count?this.time[this.start+this.count-1]:NaN}get first(){return this.count?this.time[this.start]:NaN}between(t,e,i){let s=Math.max(0,this.search(t)-1),r=Math.min(this.count,this.search(e)+1),[o,a]=[this.start+s,this.start+r],c=new Float64Array(a-o).fill(NaN);return[this.time.subarray(o,a),...i.map(l=>this.columns.get(l)?.subarray(o,a)??c)]}search(t){let[e,i]=[0,this.count];for(;e<i;){let s=e+i>>1;this.time[this.start+s]<t?e=s+1:i=s}return e}};var $i={left:46,right:10,top:8,bottom:34},Ba=class{constructor(t){this.canvas=X("canvas",{className:"phase"}),this.host=t,t.append(this.canvas)}resize(){let t=devicePixelRatio||1,{clientWidth:e,clientHeight:i}=this.host,[s,r]=[e*t,i*t].map(Math.round);(this.canvas.width!==s||this.canvas.height!==r)&&(this.canvas.width=s,this.canvas.height=r)}show(t,e,i){let s=this.canvas.getContext("2d");if(!s)return;let r=devicePixelRatio||1,[o,a]=[this.canvas.width/r,this.canvas.height/r];s.setTransform(r,0,0,r,0,0),s.clearRect(0,0,o,a);let c=[];for(let S=1;S+1<t.length;S++){let C=(e[S+1]-e[S-1])/(t[S+1]-t[S-1]);Number.isFinite(C)&&c.push([e[S],C])}let l=getComputedStyle(document.documentElement),h=l.getPropertyValue("--faint").trim();if(s.font="11px system-ui, sans-serif",s.fillStyle=h,c.length<3){s.fillText("Follow a node to see its phase plane.",12,24);return}let[u,d]=Uf(c.map(([S])=>S)),[f,g]=Uf(c.map(([,S])=>S)),y={w:o-$i.left-$i.right,h:a-$i.top-$i.bottom},m=S=>$i.left+(S-u)/(d-u)*y.w,p=S=>$i.top+(1-(S-f)/(g-f))*y.h;s.strokeStyle=l.getPropertyValue("--line").trim(),s.strokeRect($i.left,$i.top,y.w,y.h),f<0&&g>0&&(s.beginPath(),s.moveTo($i.left,p(0)),s.lineTo($i.left+y.w,p(0)),s.stroke()),s.textAlign="right";for(let S of[f,g])s.fillText(Xe(Number(S.toPrecision(2))),$i.left-4,p(S)+(S===f?0:9));s.textAlign="left",s.fillText(Xe(Number(u.toPrecision(3))),$i.left,a-20),s.textAlign="right",s.fillText(gi(Number(d.toPrecision(3)),"m"),o-$i.right,a-20),s.textAlign="center",s.fillText("height; upward velocity in m/s",$i.left+y.w/2,a-5),s.textAlign="left",s.strokeStyle=i,s.lineWidth=1.4,s.beginPath();for(let[S,C]of c)s.lineTo(m(S),p(C));s.stroke();let[v,A]=c[c.length-1];s.fillStyle=i,s.beginPath(),s.arc(m(v),p(A),4,0,2*Math.PI),s.fill()}};function Uf(n){let[t,e]=[1/0,-1/0];for(let s of n)t=Math.min(t,s),e=Math.max(e,s);let i=Math.max(1e-6,.06*(e-t));return[t-i,e+i]}var A_="uplot",R_="u-hz",C_="u-vt",P_="u-title",I_="u-wrap",L_="u-under",N_="u-over",D_="u-axis",Js="u-off",F_="u-select",U_="u-cursor-x",O_="u-cursor-y",k_="u-cursor-pt",B_="u-legend",z_="u-live",V_="u-inline",H_="u-series",G_="u-marker",Of="u-label",W_="u-value",Fo="width",Uo="height";var kf="bottom",Dr="left",Yh="right",uu="#000",Bf=uu+"0",Zh="mousemove",zf="mousedown",Jh="mouseup",Vf="mouseenter",Hf="mouseleave",Gf="dblclick",X_="resize",$_="scroll",Wf="change",Wa="dppxchange",du="--",Vr=typeof window<"u",eu=Vr?document:null,Ur=Vr?window:null,q_=Vr?navigator:null,be,za;function iu(){let n=devicePixelRatio;be!=n&&(be=n,za&&su(Wf,za,iu),za=matchMedia(`(min-resolution: ${be-.001}dppx) and (max-resolution: ${be+.001}dppx)`),Ks(Wf,za,iu),Ur.dispatchEvent(new CustomEvent(Wa)))}function ji(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function nu(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Ve(n,t,e){n.style[t]=e+"px"}function Tn(n,t,e,i){let s=eu.createElement(n);return t!=null&&ji(s,t),e?.insertBefore(s,i),s}function _n(n,t){return Tn("div",n,t)}var Xf=new WeakMap;function Xn(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Xf.get(n);r!=o&&(n.style.transform=r,Xf.set(n,r),t<0||e<0||t>i||e>s?ji(n,Js):nu(n,Js))}var $f=new WeakMap;function qf(n,t,e){let i=t+e,s=$f.get(n);i!=s&&($f.set(n,i),n.style.background=t,n.style.borderColor=e)}var Yf=new WeakMap;function Zf(n,t,e,i){let s=t+""+e,r=Yf.get(n);s!=r&&(Yf.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var fu={passive:!0},Y_={...fu,capture:!0};function Ks(n,t,e,i){t.addEventListener(n,e,i?Y_:fu)}function su(n,t,e,i){t.removeEventListener(n,e,fu)}Vr&&iu();function An(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Qi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function bp(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var wp=n=>n!=null,Ep=n=>n!=null&&n>0,qa=bp(wp),Z_=bp(Ep);function J_(n,t,e,i=0,s=!1){let r=s?Z_:qa,o=s?Ep:wp;[t,e]=r(n,t,e);let a=n[t],c=n[t];if(t>-1)if(i==1)a=n[t],c=n[e];else if(i==-1)a=n[e],c=n[t];else for(let l=t;l<=e;l++){let h=n[l];o(h)&&(h<a?a=h:h>c&&(c=h))}return[a??Ne,c??-Ne]}function Ya(n,t,e,i){let s=jf(n),r=jf(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?as:Tp,a=s==1?Qi:xn,c=r==1?xn:Qi,l=a(o(xi(n))),h=c(o(xi(t))),u=Or(e,l),d=Or(e,h);return e==10&&(l<0&&(u=De(u,-l)),h<0&&(d=De(d,-h))),i||e==2?(n=u*s,t=d*r):(n=Pp(n,u),t=Za(t,d)),[n,t]}function pu(n,t,e,i){let s=Ya(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var mu=.1,Jf={mode:3,pad:mu},ko={pad:0,soft:null,mode:0},K_={min:ko,max:ko};function Xa(n,t,e,i){return Ja(e)?Kf(n,t,e):(ko.pad=e,ko.soft=i?0:null,ko.mode=i?3:0,Kf(n,t,K_))}function Me(n,t){return n??t}function j_(n,t,e){for(t=Me(t,0),e=Me(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Kf(n,t,e){let i=e.min,s=e.max,r=Me(i.pad,0),o=Me(s.pad,0),a=Me(i.hard,-Ne),c=Me(s.hard,Ne),l=Me(i.soft,Ne),h=Me(s.soft,-Ne),u=Me(i.mode,0),d=Me(s.mode,0),f=t-n,g=as(f),y=Hi(xi(n),xi(t)),m=as(y),p=xi(m-g);(f<1e-24||p>10)&&(f=0,(n==0||t==0)&&(f=1e-24,u==2&&l!=Ne&&(r=0),d==2&&h!=-Ne&&(o=0)));let v=f||y||1e3,A=as(v),S=Or(10,Qi(A)),C=v*(f==0?n==0?.1:1:r),T=De(Pp(n-C,S/10),24),x=n>=l&&(u==1||u==3&&T<=l||u==2&&T>=l)?l:Ne,E=Hi(a,T<x&&n>=x?x:Rn(x,T)),k=v*(f==0?t==0?.1:1:o),N=De(Za(t+k,S/10),24),I=t<=h&&(d==1||d==3&&N>=h||d==2&&N<=h)?h:-Ne,V=Rn(c,N>I&&t<=I?I:Hi(I,N));return E==V&&E==0&&(V=100),[E,V]}var Q_=new Intl.NumberFormat(Vr?q_.language:"en-US"),gu=n=>Q_.format(n),tn=Math,Ga=tn.PI,xi=tn.abs,Qi=tn.floor,_i=tn.round,xn=tn.ceil,Rn=tn.min,Hi=tn.max,Or=tn.pow,jf=tn.sign,as=tn.log10,Tp=tn.log2,tx=(n,t=1)=>tn.sinh(n)*t,Kh=(n,t=1)=>tn.asinh(n/t),Ne=1/0;function Qf(n){return(as((n^n>>31)-(n>>31))|0)+1}function ru(n,t,e){return Rn(Hi(n,t),e)}function Ap(n){return typeof n=="function"}function fe(n){return Ap(n)?n:()=>n}var ex=()=>{},Rp=n=>n,Cp=(n,t)=>t,ix=n=>null,tp=n=>!0,ep=(n,t)=>n==t,nx=/\.\d*?(?=9{6,}|0{6,})/gm,js=n=>{if(Lp(n)||Rs.has(n))return n;let t=`${n}`,e=t.match(nx);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${js(s)}e${r}`}return De(n,i)};function Ys(n,t){return js(De(js(n/t))*t)}function Za(n,t){return js(xn(js(n/t))*t)}function Pp(n,t){return js(Qi(js(n/t))*t)}function De(n,t=0){if(Lp(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return _i(i)/e}var Rs=new Map;function Ip(n){return((""+n).split(".")[1]||"").length}function zo(n,t,e,i){let s=[],r=i.map(Ip);for(let o=t;o<e;o++){let a=xi(o),c=De(Or(n,o),a);for(let l=0;l<i.length;l++){let h=n==10?+`${i[l]}e${o}`:i[l]*c,u=(o>=0?0:a)+(o>=r[l]?0:r[l]),d=n==10?h:De(h,u);s.push(d),Rs.set(d,u)}}return s}var Bo={},_u=[],kr=[null,null],As=Array.isArray,Lp=Number.isInteger,sx=n=>n===void 0;function ip(n){return typeof n=="string"}function Ja(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function rx(n){return n!=null&&typeof n=="object"}var ox=Object.getPrototypeOf(Uint8Array),Np="__proto__";function Br(n,t=Ja){let e;if(As(n)){let i=n.find(s=>s!=null);if(As(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Br(n[s],t)}else e=n.slice()}else if(n instanceof ox)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Np&&(e[i]=Br(n[i],t))}else e=n;return e}function ui(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Np&&(Ja(n[s])?ui(n[s],Br(i[s])):n[s]=Br(i[s]))}return n}var ax=0,lx=1,cx=2;function hx(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function ux(n,t){if(px(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return mx(o[0])||(o=fx(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let c=n[o][0],l=c.length;for(let h=0;h<l;h++)e.add(c[h])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],c=a[0];for(let l=1;l<a.length;l++){let h=a[l],u=Array(s).fill(void 0),d=t?t[o][l]:lx,f=[];for(let g=0;g<h.length;g++){let y=h[g],m=r.get(c[g]);y===null?d!=ax&&(u[m]=y,d==cx&&f.push(m)):u[m]=y}hx(u,f,s),i.push(u)}}return i}var dx=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function fx(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let c=0;c<e;c++)a[c]=o[i[c]];s.push(a)}return s}function px(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function mx(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Hi(1,Qi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let c=n[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var Dp=["January","February","March","April","May","June","July","August","September","October","November","December"],Fp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Up(n){return n.slice(0,3)}var gx=Fp.map(Up),_x=Dp.map(Up),xx={MMMM:Dp,MMM:_x,WWWW:Fp,WWW:gx};function Do(n){return(n<10?"0":"")+n}function vx(n){return(n<10?"00":n<100?"0":"")+n}var yx={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Do(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Do(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Do(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Do(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Do(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>vx(n.getMilliseconds())};function xu(n,t){t=t||xx;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?yx[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var Mx=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Sx(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==Mx?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Op=n=>n%1==0,$a=[1,2,2.5,5],bx=zo(10,-32,0,$a),kp=zo(10,0,32,$a),wx=kp.filter(Op),Zs=bx.concat(kp),vu=`
`,Bp="{YYYY}",np=vu+Bp,zp="{M}/{D}",Oo=vu+zp,Va=Oo+"/{YY}",Vp="{aa}",Ex="{h}:{mm}",Fr=Ex+Vp,sp=vu+Fr,rp=":{ss}",we=null;function Hp(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,c=(n==1?zo(10,0,3,$a).filter(Op):zo(10,-3,0,$a)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,Bp,we,we,we,we,we,we,1],[s*28,"{MMM}",np,we,we,we,we,we,1],[s,zp,np,we,we,we,we,we,1],[i,"{h}"+Vp,Va,we,Oo,we,we,we,1],[e,Fr,Va,we,Oo,we,we,we,1],[t,rp,Va+" "+Fr,we,Oo+" "+Fr,we,sp,we,1],[n,rp+".{fff}",Va+" "+Fr,we,Oo+" "+Fr,we,sp,we,1]];function h(u){return(d,f,g,y,m,p)=>{let v=[],A=m>=o,S=m>=r&&m<o,C=u(g),T=De(C*n,3),x=jh(C.getFullYear(),A?0:C.getMonth(),S||A?1:C.getDate()),E=De(x*n,3);if(S||A){let k=S?m/r:0,N=A?m/o:0,I=T==E?T:De(jh(x.getFullYear()+N,x.getMonth()+k,1)*n,3),V=new Date(_i(I/n)),G=V.getFullYear(),D=V.getMonth();for(let H=0;I<=y;H++){let Z=jh(G+N*H,D+k*H,1),z=Z-u(De(Z*n,3));I=De((+Z+z)*n,3),I<=y&&v.push(I)}}else{let k=m>=s?s:m,N=Qi(g)-Qi(T),I=E+N+Za(T-E,k);v.push(I);let V=u(I),G=V.getHours()+V.getMinutes()/e+V.getSeconds()/i,D=m/i,H=d.axes[f]._space,Z=p/H;for(;I=De(I+m,n==1?0:3),!(I>y);)if(D>1){let z=Qi(De(G+D,6))%24,Q=u(I).getHours()-z;Q>1&&(Q=-1),I-=Q*i,G=(G+D)%24;let st=v[v.length-1];De((I-st)/m,3)*Z>=.7&&v.push(I)}else v.push(I)}return v}}return[c,l,h]}var[Tx,Ax,Rx]=Hp(1),[Cx,Px,Ix]=Hp(.001);zo(2,-53,53,[1]);function op(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function ap(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],c,l,h,u,d,f;return i.map(g=>{let y=n(g),m=y.getFullYear(),p=y.getMonth(),v=y.getDate(),A=y.getHours(),S=y.getMinutes(),C=y.getSeconds(),T=m!=c&&a[2]||p!=l&&a[3]||v!=h&&a[4]||A!=u&&a[5]||S!=d&&a[6]||C!=f&&a[7]||a[1];return c=m,l=p,h=v,u=A,d=S,f=C,T(y)})}}function Lx(n,t){let e=xu(t);return(i,s,r,o,a)=>s.map(c=>e(n(c)))}function jh(n,t,e){return new Date(n,t,e)}function lp(n,t){return t(n)}var Nx="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function cp(n,t){return(e,i,s,r)=>r==null?du:t(n(i))}function Dx(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function Fx(n,t){return n.series[t].fill(n,t)}var Ux={show:!0,live:!0,isolate:!1,mount:ex,markers:{show:!0,width:2,stroke:Dx,fill:Fx,dash:"solid"},idx:null,idxs:null,values:[]};function Ox(n,t){let e=n.cursor.points,i=_n(),s=e.size(n,t);Ve(i,Fo,s),Ve(i,Uo,s);let r=s/-2;Ve(i,"marginLeft",r),Ve(i,"marginTop",r);let o=e.width(n,t,s);return o&&Ve(i,"borderWidth",o),i}function kx(n,t){let e=n.series[t].points;return e._fill||e._stroke}function Bx(n,t){let e=n.series[t].points;return e._stroke||e._fill}function zx(n,t){return n.series[t].points.size}var Qh=[0,0];function Vx(n,t,e){return Qh[0]=t,Qh[1]=e,Qh}function Ha(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function tu(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var Hx={show:!0,x:!0,y:!0,lock:!1,move:Vx,points:{one:!1,show:Ox,size:zx,width:0,stroke:Bx,fill:kx},bind:{mousedown:Ha,mouseup:Ha,click:Ha,dblclick:Ha,mousemove:tu,mouseleave:tu,mouseenter:tu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Gp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},yu=ui({},Gp,{filter:Cp}),Wp=ui({},yu,{size:10}),Xp=ui({},Gp,{show:!1}),Mu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',$p="bold "+Mu,qp=1.5,hp={show:!0,scale:"x",stroke:uu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:$p,side:2,grid:yu,ticks:Wp,border:Xp,font:Mu,lineGap:qp,rotate:0},Gx="Value",Wx="Time",up={show:!0,scale:"x",auto:!1,sorted:1,min:Ne,max:-Ne,idxs:[]};function Xx(n,t,e,i,s){return t.map(r=>r==null?"":gu(r))}function $x(n,t,e,i,s,r,o){let a=[],c=Rs.get(s)||0;e=o?e:De(Za(e,s),c);for(let l=e;l<=i;l=De(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function ou(n,t,e,i,s,r,o){let a=[],c=n.scales[n.axes[t].scale].log,l=c==10?as:Tp,h=Qi(l(e));s=Or(c,h),c==10&&(s=Zs[An(s,Zs)]);let u=e,d=s*c;c==10&&(d=Zs[An(d,Zs)]);do a.push(u),u=u+s,c==10&&!Rs.has(u)&&(u=De(u,Rs.get(s))),u>=d&&(s=u,d=s*c,c==10&&(d=Zs[An(d,Zs)]));while(u<=i);return a}function qx(n,t,e,i,s,r,o){let c=n.scales[n.axes[t].scale].asinh,l=i>c?ou(n,t,Hi(c,e),i,s):[c],h=i>=0&&e<=0?[0]:[];return(e<-c?ou(n,t,Hi(c,-i),-e,s):[c]).reverse().map(d=>-d).concat(h,l)}var Yp=/./,Yx=/[12357]/,Zx=/[125]/,dp=/1/,au=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Jx(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],c=n.valToPos,l=r._space,h=c(10,o),u=c(9,o)-h>=l?Yp:c(7,o)-h>=l?Yx:c(5,o)-h>=l?Zx:dp;if(u==dp){let d=xi(c(1,o)-h);if(d<l)return au(t.slice().reverse(),a.distr,u,xn(l/d)).reverse()}return au(t,a.distr,u,1)}function Kx(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,c=n.valToPos,l=xi(c(1,o)-c(2,o));return l<a?au(t.slice().reverse(),3,Yp,xn(a/l)).reverse():t}function jx(n,t,e,i){return i==null?du:t==null?"":gu(t)}var fp={show:!0,scale:"y",stroke:uu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:$p,side:3,grid:yu,ticks:Wp,border:Xp,font:Mu,lineGap:qp,rotate:0};function Qx(n,t){let e=3+(n||1)*2;return De(e*t,3)}function tv(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=xi(o-r),c=n.series[t],l=a/(c.points.space*be);return i[1]-i[0]<=l}var pp={scale:null,auto:!0,sorted:0,min:Ne,max:-Ne},Zp=(n,t,e,i,s)=>s,mp={show:!0,auto:!0,sorted:0,gaps:Zp,alpha:1,facets:[ui({},pp,{scale:"x"}),ui({},pp,{scale:"y"})]},gp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Zp,alpha:1,points:{show:tv,filter:null},values:null,min:Ne,max:-Ne,idxs:[],path:null,clip:null};function ev(n,t,e,i,s){return e/10}var Jp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},iv=ui({},Jp,{time:!1,ori:1}),_p={};function Kp(n,t){let e=_p[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,c,l){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(i,s,r,o,a,c,l)}},n!=null&&(_p[n]=e)),e}var zr=1,lu=2;function Qs(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,c=r[0],l=i==2?r[1]:r[t],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],u=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,y=a.height,m=n.valToPosH,p=n.valToPosV;return h.ori==0?e(s,c,l,h,u,m,p,d,f,g,y,ja,Hr,tl,Qp,em):e(s,c,l,h,u,p,m,f,d,y,g,Qa,Gr,wu,tm,im)}function Su(n,t){let e=0,i=0,s=Me(n.bands,_u);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function nv(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,c=n.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function ls(n,t,e,i,s,r){return Qs(n,t,(o,a,c,l,h,u,d,f,g,y,m)=>{let p=o.pxRound,v=l.dir*(l.ori==0?1:-1),A=l.ori==0?Hr:Gr,S,C;v==1?(S=e,C=i):(S=i,C=e);let T=p(u(a[S],l,y,f)),x=p(d(c[S],h,m,g)),E=p(u(a[C],l,y,f)),k=p(d(r==1?h.max:h.min,h,m,g)),N=new Path2D(s);return A(N,E,k),A(N,T,k),A(N,T,x),N})}function Ka(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?tl:wu,c=e;for(let u=0;u<n.length;u++){let d=n[u];if(d[1]>d[0]){let f=d[0]-c;f>0&&a(o,c,i,f,i+r),c=d[1]}}let l=e+s-c,h=10;l>0&&a(o,c,i-h/2,l,i+r+h)}return o}function sv(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function bu(n,t,e,i,s,r,o){let a=[],c=n.length;for(let l=s==1?e:i;l>=e&&l<=i;l+=s)if(t[l]===null){let u=l,d=l;if(s==1)for(;++l<=i&&t[l]===null;)d=l;else for(;--l>=e&&t[l]===null;)d=l;let f=r(n[u]),g=d==u?f:r(n[d]),y=u-s;f=o<=0&&y>=0&&y<c?r(n[y]):f;let p=d+s;g=o>=0&&p>=0&&p<c?r(n[p]):g,g>=f&&a.push([f,g])}return a}function xp(n){return n==0?Rp:n==1?_i:t=>Ys(t,n)}function jp(n){let t=n==0?ja:Qa,e=n==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},i=n==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,h=0)=>{l==0&&h==0?i(s,r,o,a,c):(l=Rn(l,a/2,c/2),h=Rn(h,a/2,c/2),t(s,r+l,o),e(s,r+a,o,r+a,o+c,l),e(s,r+a,o+c,r,o+c,h),e(s,r,o+c,r,o,h),e(s,r,o,r+a,o,l),s.closePath())}}var ja=(n,t,e)=>{n.moveTo(t,e)},Qa=(n,t,e)=>{n.moveTo(e,t)},Hr=(n,t,e)=>{n.lineTo(t,e)},Gr=(n,t,e)=>{n.lineTo(e,t)},tl=jp(0),wu=jp(1),Qp=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},tm=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},em=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},im=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function nm(n){return(t,e,i,s,r)=>Qs(t,e,(o,a,c,l,h,u,d,f,g,y,m)=>{let{pxRound:p,points:v}=o,A,S;l.ori==0?(A=ja,S=Qp):(A=Qa,S=tm);let C=De(v.width*be,3),T=(v.size-v.width)/2*be,x=De(T*2,3),E=new Path2D,k=new Path2D,{left:N,top:I,width:V,height:G}=t.bbox;tl(k,N-x,I-x,V+x*2,G+x*2);let D=H=>{if(c[H]!=null){let Z=p(u(a[H],l,y,f)),z=p(d(c[H],h,m,g));A(E,Z+T,z),S(E,Z,z,T,0,Ga*2)}};if(r)r.forEach(D);else for(let H=i;H<=s;H++)D(H);return{stroke:C>0?E:null,fill:E,clip:k,flags:zr|lu}})}function sm(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var rv=sm(Hr),ov=sm(Gr);function rm(n){let t=Me(n?.alignGaps,0);return(e,i,s,r)=>Qs(e,i,(o,a,c,l,h,u,d,f,g,y,m)=>{[s,r]=qa(c,s,r);let p=o.pxRound,v=G=>p(u(G,l,y,f)),A=G=>p(d(G,h,m,g)),S,C;l.ori==0?(S=Hr,C=rv):(S=Gr,C=ov);let T=l.dir*(l.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zr},E=x.stroke,k=!1;if(r-s>=y*4){let G=ut=>e.posToVal(ut,l.key,!0),D=null,H=null,Z,z,ct,J=v(a[T==1?s:r]),Q=v(a[s]),st=v(a[r]),dt=G(T==1?Q+1:st-1);for(let ut=T==1?s:r;ut>=s&&ut<=r;ut+=T){let tt=a[ut],xt=(T==1?tt<dt:tt>dt)?J:v(tt),At=c[ut];xt==J?At!=null?(z=At,D==null?(S(E,xt,A(z)),Z=D=H=z):z<D?D=z:z>H&&(H=z)):At===null&&(k=!0):(D!=null&&C(E,J,A(D),A(H),A(Z),A(z)),At!=null?(z=At,S(E,xt,A(z)),D=H=Z=z):(D=H=null,At===null&&(k=!0)),J=xt,dt=G(J+T))}D!=null&&D!=H&&ct!=J&&C(E,J,A(D),A(H),A(Z),A(z))}else for(let G=T==1?s:r;G>=s&&G<=r;G+=T){let D=c[G];D===null?k=!0:D!=null&&S(E,v(a[G]),A(D))}let[I,V]=Su(e,i);if(o.fill!=null||I!=0){let G=x.fill=new Path2D(E),D=o.fillTo(e,i,o.min,o.max,I),H=A(D),Z=v(a[s]),z=v(a[r]);T==-1&&([z,Z]=[Z,z]),S(G,z,H),S(G,Z,H)}if(!o.spanGaps){let G=[];k&&G.push(...bu(a,c,s,r,T,v,t)),x.gaps=G=o.gaps(e,i,s,r,G),x.clip=Ka(G,l.ori,f,g,y,m)}return V!=0&&(x.band=V==2?[ls(e,i,s,r,E,-1),ls(e,i,s,r,E,1)]:ls(e,i,s,r,E,V)),x})}function av(n){let t=Me(n.align,1),e=Me(n.ascDesc,!1),i=Me(n.alignGaps,0),s=Me(n.extend,!1);return(r,o,a,c)=>Qs(r,o,(l,h,u,d,f,g,y,m,p,v,A)=>{[a,c]=qa(u,a,c);let S=l.pxRound,{left:C,width:T}=r.bbox,x=Q=>S(g(Q,d,v,m)),E=Q=>S(y(Q,f,A,p)),k=d.ori==0?Hr:Gr,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zr},I=N.stroke,V=d.dir*(d.ori==0?1:-1),G=E(u[V==1?a:c]),D=x(h[V==1?a:c]),H=D,Z=D;s&&t==-1&&(Z=C,k(I,Z,G)),k(I,D,G);for(let Q=V==1?a:c;Q>=a&&Q<=c;Q+=V){let st=u[Q];if(st==null)continue;let dt=x(h[Q]),ut=E(st);t==1?k(I,dt,G):k(I,H,ut),k(I,dt,ut),G=ut,H=dt}let z=H;s&&t==1&&(z=C+T,k(I,z,G));let[ct,J]=Su(r,o);if(l.fill!=null||ct!=0){let Q=N.fill=new Path2D(I),st=l.fillTo(r,o,l.min,l.max,ct),dt=E(st);k(Q,z,dt),k(Q,Z,dt)}if(!l.spanGaps){let Q=[];Q.push(...bu(h,u,a,c,V,x,i));let st=l.width*be/2,dt=e||t==1?st:-st,ut=e||t==-1?-st:st;Q.forEach(tt=>{tt[0]+=dt,tt[1]+=ut}),N.gaps=Q=l.gaps(r,o,a,c,Q),N.clip=Ka(Q,d.ori,m,p,v,A)}return J!=0&&(N.band=J==2?[ls(r,o,a,c,I,-1),ls(r,o,a,c,I,1)]:ls(r,o,a,c,I,J)),N})}function vp(n,t,e,i,s,r,o=Ne){if(n.length>1){let a=null;for(let c=0,l=1/0;c<n.length;c++)if(t[c]!==void 0){if(a!=null){let h=xi(n[c]-n[a]);h<l&&(l=h,o=xi(e(n[c],i,s,r)-e(n[a],i,s,r)))}a=c}}return o}function lv(n){n=n||Bo;let t=Me(n.size,[.6,Ne,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=fe(s),o=1-t[0],a=Me(t[1],Ne),c=Me(t[2],1),l=Me(n.disp,Bo),h=Me(n.each,f=>{}),{fill:u,stroke:d}=l;return(f,g,y,m)=>Qs(f,g,(p,v,A,S,C,T,x,E,k,N,I)=>{let V=p.pxRound,G=e,D=i*be,H=a*be,Z=c*be,z,ct;S.ori==0?[z,ct]=r(f,g):[ct,z]=r(f,g);let J=S.dir*(S.ori==0?1:-1),Q=S.ori==0?tl:wu,st=S.ori==0?h:(Ct,$t,ne,bt,Le,zt,Xt)=>{h(Ct,$t,ne,Le,bt,Xt,zt)},dt=Me(f.bands,_u).find(Ct=>Ct.series[0]==g),ut=dt!=null?dt.dir:0,tt=p.fillTo(f,g,p.min,p.max,ut),mt=V(x(tt,C,I,k)),xt,At,St,Gt=N,ie=V(p.width*be),Vt=!1,le=null,re=null,te=null,Ge=null;u!=null&&(ie==0||d!=null)&&(Vt=!0,le=u.values(f,g,y,m),re=new Map,new Set(le).forEach(Ct=>{Ct!=null&&re.set(Ct,new Path2D)}),ie>0&&(te=d.values(f,g,y,m),Ge=new Map,new Set(te).forEach(Ct=>{Ct!=null&&Ge.set(Ct,new Path2D)})));let{x0:Fe,size:ni}=l;if(Fe!=null&&ni!=null){G=1,v=Fe.values(f,g,y,m),Fe.unit==2&&(v=v.map(ne=>f.posToVal(E+ne*N,S.key,!0)));let Ct=ni.values(f,g,y,m);ni.unit==2?At=Ct[0]*N:At=T(Ct[0],S,N,E)-T(0,S,N,E),Gt=vp(v,A,T,S,N,E,Gt),St=Gt-At+D}else Gt=vp(v,A,T,S,N,E,Gt),St=Gt*o+D,At=Gt-St;St<1&&(St=0),ie>=At/2&&(ie=0),St<5&&(V=Rp);let Ce=St>0,Mi=Gt-St-(Ce?ie:0);At=V(ru(Mi,Z,H)),xt=(G==0?At/2:G==J?0:At)-G*J*((G==0?D/2:0)+(Ce?ie/2:0));let _e={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},pi=Vt?null:new Path2D,Ye=null;if(dt!=null)Ye=f.data[dt.series[1]];else{let{y0:Ct,y1:$t}=l;Ct!=null&&$t!=null&&(A=$t.values(f,g,y,m),Ye=Ct.values(f,g,y,m))}let si=z*At,U=ct*At;for(let Ct=J==1?y:m;Ct>=y&&Ct<=m;Ct+=J){let $t=A[Ct];if($t==null)continue;if(Ye!=null){let W=Ye[Ct]??0;if($t-W==0)continue;mt=x(W,C,I,k)}let ne=S.distr!=2||l!=null?v[Ct]:Ct,bt=T(ne,S,N,E),Le=x(Me($t,tt),C,I,k),zt=V(bt-xt),Xt=V(Hi(Le,mt)),R=V(Rn(Le,mt)),M=Xt-R;if($t!=null){let W=$t<0?U:si,ht=$t<0?si:U;Vt?(ie>0&&te[Ct]!=null&&Q(Ge.get(te[Ct]),zt,R+Qi(ie/2),At,Hi(0,M-ie),W,ht),le[Ct]!=null&&Q(re.get(le[Ct]),zt,R+Qi(ie/2),At,Hi(0,M-ie),W,ht)):Q(pi,zt,R+Qi(ie/2),At,Hi(0,M-ie),W,ht),st(f,g,Ct,zt-ie/2,R,At+ie,M)}}return ie>0?_e.stroke=Vt?Ge:pi:Vt||(_e._fill=p.width==0?p._fill:p._stroke??p._fill,_e.width=0),_e.fill=Vt?re:pi,_e})}function cv(n,t){let e=Me(t?.alignGaps,0);return(i,s,r,o)=>Qs(i,s,(a,c,l,h,u,d,f,g,y,m,p)=>{[r,o]=qa(l,r,o);let v=a.pxRound,A=z=>v(d(z,h,m,g)),S=z=>v(f(z,u,p,y)),C,T,x;h.ori==0?(C=ja,x=Hr,T=em):(C=Qa,x=Gr,T=im);let E=h.dir*(h.ori==0?1:-1),k=A(c[E==1?r:o]),N=k,I=[],V=[];for(let z=E==1?r:o;z>=r&&z<=o;z+=E)if(l[z]!=null){let J=c[z],Q=A(J);I.push(N=Q),V.push(S(l[z]))}let G={stroke:n(I,V,C,x,T,v),fill:null,clip:null,band:null,gaps:null,flags:zr},D=G.stroke,[H,Z]=Su(i,s);if(a.fill!=null||H!=0){let z=G.fill=new Path2D(D),ct=a.fillTo(i,s,a.min,a.max,H),J=S(ct);x(z,N,J),x(z,k,J)}if(!a.spanGaps){let z=[];z.push(...bu(c,l,r,o,E,A,e)),G.gaps=z=a.gaps(i,s,r,o,z),G.clip=Ka(z,h.ori,g,y,m,p)}return Z!=0&&(G.band=Z==2?[ls(i,s,r,o,D,-1),ls(i,s,r,o,D,1)]:ls(i,s,r,o,D,Z)),G})}function hv(n){return cv(uv,n)}function uv(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let c=Array(o),l=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=t[d+1]-t[d],u[d]=n[d+1]-n[d],l[d]=h[d]/u[d];c[0]=l[0];for(let d=1;d<o-1;d++)l[d]===0||l[d-1]===0||l[d-1]>0!=l[d]>0?c[d]=0:(c[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/l[d-1]+(u[d]+2*u[d-1])/l[d]),isFinite(c[d])||(c[d]=0));c[o-1]=l[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+u[d]/3,t[d]+c[d]*u[d]/3,n[d+1]-u[d]/3,t[d+1]-c[d+1]*u[d]/3,n[d+1],t[d+1])}return a}var cu=new Set;function yp(){for(let n of cu)n.syncRect(!0)}Vr&&(Ks(X_,Ur,yp),Ks($_,Ur,yp,!0),Ks(Wa,Ur,()=>{Ii.pxRatio=be}));var dv=rm(),fv=nm();function Mp(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>hu(r,o,t,e))}function pv(n,t){return n.map((e,i)=>i==0?{}:ui({},t,e))}function hu(n,t,e,i){return ui({},t==0?e:i,n)}function om(n,t,e){return t==null?kr:[t,e]}var mv=om;function gv(n,t,e){return t==null?kr:Xa(t,e,mu,!0)}function am(n,t,e,i){return t==null?kr:Ya(t,e,n.scales[i].log,!1)}var _v=am;function lm(n,t,e,i){return t==null?kr:pu(t,e,n.scales[i].log,!1)}var xv=lm;function vv(n,t,e,i,s){let r=Hi(Qf(n),Qf(t)),o=t-n,a=An(s/i*o,e);do{let c=e[a],l=i*c/o;if(l>=s&&r+(c<5?Rs.get(c):0)<=17)return[c,l]}while(++a<e.length);return[0,0]}function Sp(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=_i((e=+s)*be))+"px"),[n,t,e]}function yv(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=De(t[2]*be,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Ii(n,t,e){let i={mode:Me(n.mode,1)},s=i.mode;function r(_,b,P,L){let B=b.valToPct(_);return L+P*(b.dir==-1?1-B:B)}function o(_,b,P,L){let B=b.valToPct(_);return L+P*(b.dir==-1?B:1-B)}function a(_,b,P,L){return b.ori==0?r(_,b,P,L):o(_,b,P,L)}i.valToPosH=r,i.valToPosV=o;let c=!1;i.status=0;let l=i.root=_n(A_);if(n.id!=null&&(l.id=n.id),ji(l,n.class),n.title){let _=_n(P_,l);_.textContent=n.title}let h=Tn("canvas"),u=i.ctx=h.getContext("2d"),d=_n(I_,l);Ks("click",d,_=>{_.target===g&&(ke!=wr||We!=Er)&&Ci.click(i,_)},!0);let f=i.under=_n(L_,d);d.appendChild(h);let g=i.over=_n(N_,d);n=Br(n);let y=+Me(n.pxAlign,1),m=xp(y);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let p=n.ms||.001,v=i.series=s==1?Mp(n.series||[],up,gp,!1):pv(n.series||[null],mp),A=i.axes=Mp(n.axes||[],hp,fp,!0),S=i.scales={},C=i.bands=n.bands||[];C.forEach(_=>{_.fill=fe(_.fill||null),_.dir=Me(_.dir,-1)});let T=s==2?v[1].facets[0].scale:v[0].scale,x={axes:rs,series:he},E=(n.drawOrder||["axes","series"]).map(_=>x[_]);function k(_){let b=_.distr==3?P=>as(P>0?P:_.clamp(i,P,_.min,_.max,_.key)):_.distr==4?P=>Kh(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let L=b(P),{_min:B,_max:Y}=_,at=Y-B;return(L-B)/at}}function N(_){let b=S[_];if(b==null){let P=(n.scales||Bo)[_]||Bo;if(P.from!=null){N(P.from);let L=ui({},S[P.from],P,{key:_});L.valToPct=k(L),S[_]=L}else{b=S[_]=ui({},_==T?Jp:iv,P),b.key=_;let L=b.time,B=b.range,Y=As(B);if((_!=T||s==2&&!L)&&(Y&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?Jf:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?Jf:{mode:1,hard:B[1],soft:B[1]}},Y=!1),!Y&&Ja(B))){let at=B;B=(ft,yt,Nt)=>yt==null?kr:Xa(yt,Nt,at)}b.range=fe(B||(L?mv:_==T?b.distr==3?_v:b.distr==4?xv:om:b.distr==3?am:b.distr==4?lm:gv)),b.auto=fe(Y?!1:b.auto),b.clamp=fe(b.clamp||ev),b._min=b._max=null,b.valToPct=k(b)}}}N("x"),N("y"),s==1&&v.forEach(_=>{N(_.scale)}),A.forEach(_=>{N(_.scale)});for(let _ in n.scales)N(_);let I=S[T],V=I.distr,G,D;I.ori==0?(ji(l,R_),G=r,D=o):(ji(l,C_),G=o,D=r);let H={};for(let _ in S){let b=S[_];(b.min!=null||b.max!=null)&&(H[_]={min:b.min,max:b.max},b.min=b.max=null)}let Z=n.tzDate||(_=>new Date(_i(_/p))),z=n.fmtDate||xu,ct=p==1?Rx(Z):Ix(Z),J=ap(Z,op(p==1?Ax:Px,z)),Q=cp(Z,lp(Nx,z)),st=[],dt=i.legend=ui({},Ux,n.legend),ut=i.cursor=ui({},Hx,{drag:{y:s==2}},n.cursor),tt=dt.show,mt=ut.show,xt=dt.markers;dt.idxs=st,xt.width=fe(xt.width),xt.dash=fe(xt.dash),xt.stroke=fe(xt.stroke),xt.fill=fe(xt.fill);let At,St,Gt,ie=[],Vt=[],le,re=!1,te={};if(dt.live){let _=v[1]?v[1].values:null;re=_!=null,le=re?_(i,1,0):{_:0};for(let b in le)te[b]=du}if(tt)if(At=Tn("table",B_,l),Gt=Tn("tbody",null,At),dt.mount(i,At),re){St=Tn("thead",null,At,Gt);let _=Tn("tr",null,St);Tn("th",null,_);for(var Ge in le)Tn("th",Of,_).textContent=Ge}else ji(At,V_),dt.live&&ji(At,z_);let Fe={show:!0},ni={show:!1};function Ce(_,b){if(b==0&&(re||!dt.live||s==2))return kr;let P=[],L=Tn("tr",H_,Gt,Gt.childNodes[b]);ji(L,_.class),_.show||ji(L,Js);let B=Tn("th",null,L);if(xt.show){let ft=_n(G_,B);if(b>0){let yt=xt.width(i,b);yt&&(ft.style.border=yt+"px "+xt.dash(i,b)+" "+xt.stroke(i,b)),ft.style.background=xt.fill(i,b)}}let Y=_n(Of,B);_.label instanceof HTMLElement?Y.appendChild(_.label):Y.textContent=_.label,b>0&&(xt.show||(Y.style.color=_.width>0?xt.stroke(i,b):xt.fill(i,b)),_e("click",B,ft=>{if(ut._lock)return;Zt(ft);let yt=v.indexOf(_);if((ft.ctrlKey||ft.metaKey)!=dt.isolate){let Nt=v.some((Dt,Ut)=>Ut>0&&Ut!=yt&&Dt.show);v.forEach((Dt,Ut)=>{Ut>0&&Vn(Ut,Nt?Ut==yt?Fe:ni:Fe,!0,li.setSeries)})}else Vn(yt,{show:!_.show},!0,li.setSeries)},!1),Jt&&_e(Vf,B,ft=>{ut._lock||(Zt(ft),Vn(v.indexOf(_),Ar,!0,li.setSeries))},!1));for(var at in le){let ft=Tn("td",W_,L);ft.textContent="--",P.push(ft)}return[L,P]}let Mi=new Map;function _e(_,b,P,L=!0){let B=Mi.get(b)||{},Y=ut.bind[_](i,b,P,L);Y&&(Ks(_,b,B[_]=Y),Mi.set(b,B))}function pi(_,b,P){let L=Mi.get(b)||{};for(let B in L)(_==null||B==_)&&(su(B,b,L[B]),delete L[B]);_==null&&Mi.delete(b)}let Ye=0,si=0,U=0,Ct=0,$t=0,ne=0,bt=$t,Le=ne,zt=U,Xt=Ct,R=0,M=0,W=0,ht=0;i.bbox={};let ot=!1,_t=!1,vt=!1,et=!1,nt=!1,pt=!1;function F(_,b,P){(P||_!=i.width||b!=i.height)&&rt(_,b),oe(!1),vt=!0,_t=!0,Li()}function rt(_,b){i.width=Ye=U=_,i.height=si=Ct=b,$t=ne=0,Mt(),Ht();let P=i.bbox;R=P.left=Ys($t*be,.5),M=P.top=Ys(ne*be,.5),W=P.width=Ys(U*be,.5),ht=P.height=Ys(Ct*be,.5)}let it=3;function wt(){let _=!1,b=0;for(;!_;){b++;let P=Mr(b),L=zn(b);_=b==it||P&&L,_||(rt(i.width,i.height),_t=!0)}}function gt({width:_,height:b}){F(_,b)}i.setSize=gt;function Mt(){let _=!1,b=!1,P=!1,L=!1;A.forEach((B,Y)=>{if(B.show&&B._show){let{side:at,_size:ft}=B,yt=at%2,Nt=B.label!=null?B.labelSize:0,Dt=ft+Nt;Dt>0&&(yt?(U-=Dt,at==3?($t+=Dt,L=!0):P=!0):(Ct-=Dt,at==0?(ne+=Dt,_=!0):b=!0))}}),kn[0]=_,kn[1]=P,kn[2]=b,kn[3]=L,U-=bn[1]+bn[3],$t+=bn[3],Ct-=bn[2]+bn[0],ne+=bn[0]}function Ht(){let _=$t+U,b=ne+Ct,P=$t,L=ne;function B(Y,at){switch(Y){case 1:return _+=at,_-at;case 2:return b+=at,b-at;case 3:return P-=at,P+at;case 0:return L-=at,L+at}}A.forEach((Y,at)=>{if(Y.show&&Y._show){let ft=Y.side;Y._pos=B(ft,Y._size),Y.label!=null&&(Y._lpos=B(ft,Y.labelSize))}})}if(ut.dataIdx==null){let _=ut.hover,b=_.skip=new Set(_.skip??[]);b.add(void 0);let P=_.prox=fe(_.prox),L=_.bias??=0;ut.dataIdx=(B,Y,at,ft)=>{if(Y==0)return at;let yt=at,Nt=P(B,Y,at,ft)??Ne,Dt=Nt>=0&&Nt<Ne,Ut=I.ori==0?U:Ct,ee=ut.left,Se=t[0],ye=t[Y];if(b.has(ye[at])){yt=null;let ue=null,qt=null,Wt;if(L==0||L==-1)for(Wt=at;ue==null&&Wt-- >0;)b.has(ye[Wt])||(ue=Wt);if(L==0||L==1)for(Wt=at;qt==null&&Wt++<ye.length;)b.has(ye[Wt])||(qt=Wt);if(ue!=null||qt!=null)if(Dt){let ze=ue==null?-1/0:G(Se[ue],I,Ut,0),Ke=qt==null?1/0:G(Se[qt],I,Ut,0),Ei=ee-ze,Pe=Ke-ee;Ei<=Pe?Ei<=Nt&&(yt=ue):Pe<=Nt&&(yt=qt)}else yt=qt==null?ue:ue==null?qt:at-ue<=qt-at?ue:qt}else Dt&&xi(ee-G(Se[at],I,Ut,0))>Nt&&(yt=null);return yt}}let Zt=_=>{ut.event=_};ut.idxs=st,ut._lock=!1;let lt=ut.points;lt.show=fe(lt.show),lt.size=fe(lt.size),lt.stroke=fe(lt.stroke),lt.width=fe(lt.width),lt.fill=fe(lt.fill);let Ot=i.focus=ui({},n.focus||{alpha:.3},ut.focus),Jt=Ot.prox>=0,Rt=Jt&&lt.one,se=[],Oe=[],Oi=[];function So(_,b){let P=lt.show(i,b);if(P instanceof HTMLElement)return ji(P,k_),ji(P,_.class),Xn(P,-10,-10,U,Ct),g.insertBefore(P,se[b]),P}function xr(_,b){if(s==1||b>0){let P=s==1&&S[_.scale].time,L=_.value;_.value=P?ip(L)?cp(Z,lp(L,z)):L||Q:L||jx,_.label=_.label||(P?Wx:Gx)}if(Rt||b>0){_.width=_.width==null?1:_.width,_.paths=_.paths||dv||ix,_.fillTo=fe(_.fillTo||nv),_.pxAlign=+Me(_.pxAlign,y),_.pxRound=xp(_.pxAlign),_.stroke=fe(_.stroke||null),_.fill=fe(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=Qx(Hi(1,_.width),1),L=_.points=ui({},{size:P,width:Hi(1,P*.2),stroke:_.stroke,space:P*2,paths:fv,_stroke:null,_fill:null},_.points);L.show=fe(L.show),L.filter=fe(L.filter),L.fill=fe(L.fill),L.stroke=fe(L.stroke),L.paths=fe(L.paths),L.pxAlign=_.pxAlign}if(tt){let P=Ce(_,b);ie.splice(b,0,P[0]),Vt.splice(b,0,P[1]),dt.values.push(null)}if(mt){st.splice(b,0,null);let P=null;Rt?b==0&&(P=So(_,b)):b>0&&(P=So(_,b)),se.splice(b,0,P),Oe.splice(b,0,0),Oi.splice(b,0,0)}wi("addSeries",b)}function Nh(_,b){b=b??v.length,_=s==1?hu(_,b,up,gp):hu(_,b,{},mp),v.splice(b,0,_),xr(v[b],b)}i.addSeries=Nh;function Ia(_){if(v.splice(_,1),tt){dt.values.splice(_,1),Vt.splice(_,1);let b=ie.splice(_,1)[0];pi(null,b.firstChild),b.remove()}mt&&(st.splice(_,1),se.splice(_,1)[0].remove(),Oe.splice(_,1),Oi.splice(_,1)),wi("delSeries",_)}i.delSeries=Ia;let kn=[!1,!1,!1,!1];function is(_,b){if(_._show=_.show,_.show){let P=_.side%2,L=S[_.scale];L==null&&(_.scale=P?v[1].scale:T,L=S[_.scale]);let B=L.time;_.size=fe(_.size),_.space=fe(_.space),_.rotate=fe(_.rotate),As(_.incrs)&&_.incrs.forEach(at=>{!Rs.has(at)&&Rs.set(at,Ip(at))}),_.incrs=fe(_.incrs||(L.distr==2?wx:B?p==1?Tx:Cx:Zs)),_.splits=fe(_.splits||(B&&L.distr==1?ct:L.distr==3?ou:L.distr==4?qx:$x)),_.stroke=fe(_.stroke),_.grid.stroke=fe(_.grid.stroke),_.ticks.stroke=fe(_.ticks.stroke),_.border.stroke=fe(_.border.stroke);let Y=_.values;_.values=As(Y)&&!As(Y[0])?fe(Y):B?As(Y)?ap(Z,op(Y,z)):ip(Y)?Lx(Z,Y):Y||J:Y||Xx,_.filter=fe(_.filter||(L.distr>=3&&L.log==10?Jx:L.distr==3&&L.log==2?Kx:Cp)),_.font=Sp(_.font),_.labelFont=Sp(_.labelFont),_._size=_.size(i,null,b,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(kn[b]=!0,_._el=_n(D_,d))}}function ns(_,b,P,L){let[B,Y,at,ft]=P,yt=b%2,Nt=0;return yt==0&&(ft||Y)&&(Nt=b==0&&!B||b==2&&!at?_i(hp.size/3):0),yt==1&&(B||at)&&(Nt=b==1&&!Y||b==3&&!ft?_i(fp.size/2):0),Nt}let bo=i.padding=(n.padding||[ns,ns,ns,ns]).map(_=>fe(Me(_,ns))),bn=i._padding=bo.map((_,b)=>_(i,b,kn,0)),Ze,ti=null,ei=null,Bn=s==1?v[0].idxs:null,Yi=null,Ms=!1;function wo(_,b){if(t=_??[],i.data=i._data=t,s==2){Ze=0;for(let P=1;P<v.length;P++)Ze+=t[P][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),Yi=t[0],Ze=Yi.length;let P=t;if(V==2){P=t.slice();let L=P[0]=Array(Ze);for(let B=0;B<Ze;B++)L[B]=B}i._data=t=P}if(oe(!0),wi("setData"),V==2&&(vt=!0),b!==!1){let P=I;P.auto(i,Ms)?Eo():ws(T,P.min,P.max),et=et||ut.left>=0,pt=!0,Li()}}i.setData=wo;function Eo(){Ms=!0;let _,b;s==1&&(Ze>0?(ti=Bn[0]=0,ei=Bn[1]=Ze-1,_=t[0][ti],b=t[0][ei],V==2?(_=ti,b=ei):_==b&&(V==3?[_,b]=Ya(_,_,I.log,!1):V==4?[_,b]=pu(_,_,I.log,!1):I.time?b=_+_i(86400/p):[_,b]=Xa(_,b,mu,!0))):(ti=Bn[0]=_=null,ei=Bn[1]=b=null)),ws(T,_,b)}let vr,Ss,yr,w,O,j,$,q,Et,Pt;function Tt(_,b,P,L,B,Y){_??=Bf,P??=_u,L??="butt",B??=Bf,Y??="round",_!=vr&&(u.strokeStyle=vr=_),B!=Ss&&(u.fillStyle=Ss=B),b!=yr&&(u.lineWidth=yr=b),Y!=O&&(u.lineJoin=O=Y),L!=j&&(u.lineCap=j=L),P!=w&&u.setLineDash(w=P)}function It(_,b,P,L){b!=Ss&&(u.fillStyle=Ss=b),_!=$&&(u.font=$=_),P!=q&&(u.textAlign=q=P),L!=Et&&(u.textBaseline=Et=L)}function Bt(_,b,P,L,B=0){if(L.length>0&&_.auto(i,Ms)&&(b==null||b.min==null)){let Y=Me(ti,0),at=Me(ei,L.length-1),ft=P.min==null?J_(L,Y,at,B,_.distr==3):[P.min,P.max];_.min=Rn(_.min,P.min=ft[0]),_.max=Hi(_.max,P.max=ft[1])}}let Kt={min:null,max:null};function ce(){for(let L in S){let B=S[L];H[L]==null&&(B.min==null||H[T]!=null&&B.auto(i,Ms))&&(H[L]=Kt)}for(let L in S){let B=S[L];H[L]==null&&B.from!=null&&H[B.from]!=null&&(H[L]=Kt)}H[T]!=null&&oe(!0);let _={};for(let L in H){let B=H[L];if(B!=null){let Y=_[L]=Br(S[L],rx);if(B.min!=null)ui(Y,B);else if(L!=T||s==2)if(Ze==0&&Y.from==null){let at=Y.range(i,null,null,L);Y.min=at[0],Y.max=at[1]}else Y.min=Ne,Y.max=-Ne}}if(Ze>0){v.forEach((L,B)=>{if(s==1){let Y=L.scale,at=H[Y];if(at==null)return;let ft=_[Y];if(B==0){let yt=ft.range(i,ft.min,ft.max,Y);ft.min=yt[0],ft.max=yt[1],ti=An(ft.min,t[0]),ei=An(ft.max,t[0]),ei-ti>1&&(t[0][ti]<ft.min&&ti++,t[0][ei]>ft.max&&ei--),L.min=Yi[ti],L.max=Yi[ei]}else L.show&&L.auto&&Bt(ft,at,L,t[B],L.sorted);L.idxs[0]=ti,L.idxs[1]=ei}else if(B>0&&L.show&&L.auto){let[Y,at]=L.facets,ft=Y.scale,yt=at.scale,[Nt,Dt]=t[B],Ut=_[ft],ee=_[yt];Ut!=null&&Bt(Ut,H[ft],Y,Nt,Y.sorted),ee!=null&&Bt(ee,H[yt],at,Dt,at.sorted),L.min=at.min,L.max=at.max}});for(let L in _){let B=_[L],Y=H[L];if(B.from==null&&(Y==null||Y.min==null)){let at=B.range(i,B.min==Ne?null:B.min,B.max==-Ne?null:B.max,L);B.min=at[0],B.max=at[1]}}}for(let L in _){let B=_[L];if(B.from!=null){let Y=_[B.from];if(Y.min==null)B.min=B.max=null;else{let at=B.range(i,Y.min,Y.max,L);B.min=at[0],B.max=at[1]}}}let b={},P=!1;for(let L in _){let B=_[L],Y=S[L];if(Y.min!=B.min||Y.max!=B.max){Y.min=B.min,Y.max=B.max;let at=Y.distr;Y._min=at==3?as(Y.min):at==4?Kh(Y.min,Y.asinh):at==100?Y.fwd(Y.min):Y.min,Y._max=at==3?as(Y.max):at==4?Kh(Y.max,Y.asinh):at==100?Y.fwd(Y.max):Y.max,b[L]=P=!0}}if(P){v.forEach((L,B)=>{s==2?B>0&&b.y&&(L._paths=null):b[L.scale]&&(L._paths=null)});for(let L in b)vt=!0,wi("setScale",L);mt&&ut.left>=0&&(et=pt=!0)}for(let L in H)H[L]=null}function kt(_){let b=ru(ti-1,0,Ze-1),P=ru(ei+1,0,Ze-1);for(;_[b]==null&&b>0;)b--;for(;_[P]==null&&P<Ze-1;)P++;return[b,P]}function he(){if(Ze>0){let _=v.some(b=>b._focus)&&Pt!=Ot.alpha;_&&(u.globalAlpha=Pt=Ot.alpha),v.forEach((b,P)=>{if(P>0&&b.show&&(qe(P,!1),qe(P,!0),b._paths==null)){let L=Pt;Pt!=b.alpha&&(u.globalAlpha=Pt=b.alpha);let B=s==2?[0,t[P][0].length-1]:kt(t[P]);b._paths=b.paths(i,P,B[0],B[1]),Pt!=L&&(u.globalAlpha=Pt=L)}}),v.forEach((b,P)=>{if(P>0&&b.show){let L=Pt;Pt!=b.alpha&&(u.globalAlpha=Pt=b.alpha),b._paths!=null&&Te(P,!1);{let B=b._paths!=null?b._paths.gaps:null,Y=b.points.show(i,P,ti,ei,B),at=b.points.filter(i,P,Y,B);(Y||at)&&(b.points._paths=b.points.paths(i,P,ti,ei,at),Te(P,!0))}Pt!=L&&(u.globalAlpha=Pt=L),wi("drawSeries",P)}}),_&&(u.globalAlpha=Pt=1)}}function qe(_,b){let P=b?v[_].points:v[_];P._stroke=P.stroke(i,_),P._fill=P.fill(i,_)}function Te(_,b){let P=b?v[_].points:v[_],{stroke:L,fill:B,clip:Y,flags:at,_stroke:ft=P._stroke,_fill:yt=P._fill,_width:Nt=P.width}=P._paths;Nt=De(Nt*be,3);let Dt=null,Ut=Nt%2/2;b&&yt==null&&(yt=Nt>0?"#fff":ft);let ee=P.pxAlign==1&&Ut>0;if(ee&&u.translate(Ut,Ut),!b){let Se=R-Nt/2,ye=M-Nt/2,ue=W+Nt,qt=ht+Nt;Dt=new Path2D,Dt.rect(Se,ye,ue,qt)}b?Ft(ft,Nt,P.dash,P.cap,yt,L,B,at,Y):Ae(_,ft,Nt,P.dash,P.cap,yt,L,B,at,Dt,Y),ee&&u.translate(-Ut,-Ut)}function Ae(_,b,P,L,B,Y,at,ft,yt,Nt,Dt){let Ut=!1;yt!=0&&C.forEach((ee,Se)=>{if(ee.series[0]==_){let ye=v[ee.series[1]],ue=t[ee.series[1]],qt=(ye._paths||Bo).band;As(qt)&&(qt=ee.dir==1?qt[0]:qt[1]);let Wt,ze=null;ye.show&&qt&&j_(ue,ti,ei)?(ze=ee.fill(i,Se)||Y,Wt=ye._paths.clip):qt=null,Ft(b,P,L,B,ze,at,ft,yt,Nt,Dt,Wt,qt),Ut=!0}}),Ut||Ft(b,P,L,B,Y,at,ft,yt,Nt,Dt)}let mi=zr|lu;function Ft(_,b,P,L,B,Y,at,ft,yt,Nt,Dt,Ut){Tt(_,b,P,L,B),(yt||Nt||Ut)&&(u.save(),yt&&u.clip(yt),Nt&&u.clip(Nt)),Ut?(ft&mi)==mi?(u.clip(Ut),Dt&&u.clip(Dt),de(B,at),ri(_,Y,b)):ft&lu?(de(B,at),u.clip(Ut),ri(_,Y,b)):ft&zr&&(u.save(),u.clip(Ut),Dt&&u.clip(Dt),de(B,at),u.restore(),ri(_,Y,b)):(de(B,at),ri(_,Y,b)),(yt||Nt||Ut)&&u.restore()}function ri(_,b,P){P>0&&(b instanceof Map?b.forEach((L,B)=>{u.strokeStyle=vr=B,u.stroke(L)}):b!=null&&_&&u.stroke(b))}function de(_,b){b instanceof Map?b.forEach((P,L)=>{u.fillStyle=Ss=L,u.fill(P)}):b!=null&&_&&u.fill(b)}function ss(_,b,P,L){let B=A[_],Y;if(L<=0)Y=[0,0];else{let at=B._space=B.space(i,_,b,P,L),ft=B._incrs=B.incrs(i,_,b,P,L,at);Y=vv(b,P,ft,L,at)}return B._found=Y}function oi(_,b,P,L,B,Y,at,ft,yt,Nt){let Dt=at%2/2;y==1&&u.translate(Dt,Dt),Tt(ft,at,yt,Nt,ft),u.beginPath();let Ut,ee,Se,ye,ue=B+(L==0||L==3?-Y:Y);P==0?(ee=B,ye=ue):(Ut=B,Se=ue);for(let qt=0;qt<_.length;qt++)b[qt]!=null&&(P==0?Ut=Se=_[qt]:ee=ye=_[qt],u.moveTo(Ut,ee),u.lineTo(Se,ye));u.stroke(),y==1&&u.translate(-Dt,-Dt)}function Mr(_){let b=!0;return A.forEach((P,L)=>{if(!P.show)return;let B=S[P.scale];if(B.min==null){P._show&&(b=!1,P._show=!1,oe(!1));return}else P._show||(b=!1,P._show=!0,oe(!1));let Y=P.side,at=Y%2,{min:ft,max:yt}=B,[Nt,Dt]=ss(L,ft,yt,at==0?U:Ct);if(Dt==0)return;let Ut=B.distr==2,ee=P._splits=P.splits(i,L,ft,yt,Nt,Dt,Ut),Se=B.distr==2?ee.map(Wt=>Yi[Wt]):ee,ye=B.distr==2?Yi[ee[1]]-Yi[ee[0]]:Nt,ue=P._values=P.values(i,P.filter(i,Se,L,Dt,ye),L,Dt,ye);P._rotate=Y==2?P.rotate(i,ue,L,Dt):0;let qt=P._size;P._size=xn(P.size(i,ue,L,_)),qt!=null&&P._size!=qt&&(b=!1)}),b}function zn(_){let b=!0;return bo.forEach((P,L)=>{let B=P(i,L,kn,_);B!=bn[L]&&(b=!1),bn[L]=B}),b}function rs(){for(let _=0;_<A.length;_++){let b=A[_];if(!b.show||!b._show)continue;let P=b.side,L=P%2,B,Y,at=b.stroke(i,_),ft=P==0||P==3?-1:1,[yt,Nt]=b._found;if(b.label!=null){let zi=b.labelGap*ft,Ki=_i((b._lpos+zi)*be);It(b.labelFont[0],at,"center",P==2?"top":kf),u.save(),L==1?(B=Y=0,u.translate(Ki,_i(M+ht/2)),u.rotate((P==3?-Ga:Ga)/2)):(B=_i(R+W/2),Y=Ki);let $s=Ap(b.label)?b.label(i,_,yt,Nt):b.label;u.fillText($s,B,Y),u.restore()}if(Nt==0)continue;let Dt=S[b.scale],Ut=L==0?W:ht,ee=L==0?R:M,Se=b._splits,ye=Dt.distr==2?Se.map(zi=>Yi[zi]):Se,ue=Dt.distr==2?Yi[Se[1]]-Yi[Se[0]]:yt,qt=b.ticks,Wt=b.border,ze=qt.show?qt.size:0,Ke=_i(ze*be),Ei=_i((b.alignTo==2?b._size-ze-b.gap:b.gap)*be),Pe=b._rotate*-Ga/180,je=m(b._pos*be),Zi=(Ke+Ei)*ft,Bi=je+Zi;Y=L==0?Bi:0,B=L==1?Bi:0;let un=b.font[0],wn=b.align==1?Dr:b.align==2?Yh:Pe>0?Dr:Pe<0?Yh:L==0?"center":P==3?Yh:Dr,Gn=Pe||L==1?"middle":P==2?"top":kf;It(un,at,wn,Gn);let Ji=b.font[1]*b.lineGap,dn=Se.map(zi=>m(a(zi,Dt,Ut,ee))),En=b._values;for(let zi=0;zi<En.length;zi++){let Ki=En[zi];if(Ki!=null){L==0?B=dn[zi]:Y=dn[zi],Ki=""+Ki;let $s=Ki.indexOf(`
`)==-1?[Ki]:Ki.split(/\n/gm);for(let Vi=0;Vi<$s.length;Vi++){let Cf=$s[Vi];Pe?(u.save(),u.translate(B,Y+Vi*Ji),u.rotate(Pe),u.fillText(Cf,0,0),u.restore()):u.fillText(Cf,B,Y+Vi*Ji)}}}qt.show&&oi(dn,qt.filter(i,ye,_,Nt,ue),L,P,je,Ke,De(qt.width*be,3),qt.stroke(i,_),qt.dash,qt.cap);let Wn=b.grid;Wn.show&&oi(dn,Wn.filter(i,ye,_,Nt,ue),L,L==0?2:1,L==0?M:R,L==0?ht:W,De(Wn.width*be,3),Wn.stroke(i,_),Wn.dash,Wn.cap),Wt.show&&oi([je],[1],L==0?1:0,L==0?1:2,L==1?M:R,L==1?ht:W,De(Wt.width*be,3),Wt.stroke(i,_),Wt.dash,Wt.cap)}wi("drawAxes")}function oe(_){v.forEach((b,P)=>{P>0&&(b._paths=null,_&&(s==1?(b.min=null,b.max=null):b.facets.forEach(L=>{L.min=null,L.max=null})))})}let Je=!1,ki=!1,Re=[];function ai(){ki=!1;for(let _=0;_<Re.length;_++)wi(...Re[_]);Re.length=0}function Li(){Je||(dx(uf),Je=!0)}function La(_,b=!1){Je=!0,ki=b,_(i),uf(),b&&Re.length>0&&queueMicrotask(ai)}i.batch=La;function uf(){if(ot&&(ce(),ot=!1),vt&&(wt(),vt=!1),_t){if(Ve(f,Dr,$t),Ve(f,"top",ne),Ve(f,Fo,U),Ve(f,Uo,Ct),Ve(g,Dr,$t),Ve(g,"top",ne),Ve(g,Fo,U),Ve(g,Uo,Ct),Ve(d,Fo,Ye),Ve(d,Uo,si),h.width=_i(Ye*be),h.height=_i(si*be),A.forEach(({_el:_,_show:b,_size:P,_pos:L,side:B})=>{if(_!=null)if(b){let Y=B===3||B===0?P:0,at=B%2==1;Ve(_,at?"left":"top",L-Y),Ve(_,at?"width":"height",P),Ve(_,at?"top":"left",at?ne:$t),Ve(_,at?"height":"width",at?Ct:U),nu(_,Js)}else ji(_,Js)}),vr=Ss=yr=O=j=$=q=Et=w=null,Pt=1,Ro(!0),$t!=bt||ne!=Le||U!=zt||Ct!=Xt){oe(!1);let _=U/zt,b=Ct/Xt;if(mt&&!et&&ut.left>=0){ut.left*=_,ut.top*=b,Sr&&Xn(Sr,_i(ut.left),0,U,Ct),br&&Xn(br,0,_i(ut.top),U,Ct);for(let P=0;P<se.length;P++){let L=se[P];L!=null&&(Oe[P]*=_,Oi[P]*=b,Xn(L,xn(Oe[P]),xn(Oi[P]),U,Ct))}}if(Be.show&&!nt&&Be.left>=0&&Be.width>0){Be.left*=_,Be.width*=_,Be.top*=b,Be.height*=b;for(let P in Bh)Ve(Tr,P,Be[P])}bt=$t,Le=ne,zt=U,Xt=Ct}wi("setSize"),_t=!1}Ye>0&&si>0&&(u.clearRect(0,0,h.width,h.height),wi("drawClear"),E.forEach(_=>_()),wi("draw")),Be.show&&nt&&(Na(Be),nt=!1),mt&&et&&(Xs(null,!0,!1),et=!1),dt.show&&dt.live&&pt&&(Oh(),pt=!1),c||(c=!0,i.status=1,wi("ready")),Ms=!1,Je=!1}i.redraw=(_,b)=>{vt=b||!1,_!==!1?ws(T,I.min,I.max):Li()};function Dh(_,b){let P=S[_];if(P.from==null){if(Ze==0){let L=P.range(i,b.min,b.max,_);b.min=L[0],b.max=L[1]}if(b.min>b.max){let L=b.min;b.min=b.max,b.max=L}if(Ze>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;_==T&&P.distr==2&&Ze>0&&(b.min=An(b.min,t[0]),b.max=An(b.max,t[0]),b.min==b.max&&b.max++),H[_]=b,ot=!0,Li()}}i.setScale=Dh;let Fh,Uh,Sr,br,df,ff,wr,Er,pf,mf,ke,We,bs=!1,Ci=ut.drag,Si=Ci.x,bi=Ci.y;mt&&(ut.x&&(Fh=_n(U_,g)),ut.y&&(Uh=_n(O_,g)),I.ori==0?(Sr=Fh,br=Uh):(Sr=Uh,br=Fh),ke=ut.left,We=ut.top);let Be=i.select=ui({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Tr=Be.show?_n(F_,Be.over?g:f):null;function Na(_,b){if(Be.show){for(let P in _)Be[P]=_[P],P in Bh&&Ve(Tr,P,_[P]);b!==!1&&wi("setSelect")}}i.setSelect=Na;function K0(_){if(v[_].show)tt&&nu(ie[_],Js);else if(tt&&ji(ie[_],Js),mt){let P=Rt?se[0]:se[_];P!=null&&Xn(P,-10,-10,U,Ct)}}function ws(_,b,P){Dh(_,{min:b,max:P})}function Vn(_,b,P,L){b.focus!=null&&i_(_),b.show!=null&&v.forEach((B,Y)=>{Y>0&&(_==Y||_==null)&&(B.show=b.show,K0(Y),s==2?(ws(B.facets[0].scale,null,null),ws(B.facets[1].scale,null,null)):ws(B.scale,null,null),Li())}),P!==!1&&wi("setSeries",_,b),L&&Co("setSeries",i,_,b)}i.setSeries=Vn;function j0(_,b){ui(C[_],b)}function Q0(_,b){_.fill=fe(_.fill||null),_.dir=Me(_.dir,-1),b=b??C.length,C.splice(b,0,_)}function t_(_){_==null?C.length=0:C.splice(_,1)}i.addBand=Q0,i.setBand=j0,i.delBand=t_;function e_(_,b){v[_].alpha=b,mt&&se[_]!=null&&(se[_].style.opacity=b),tt&&ie[_]&&(ie[_].style.opacity=b)}let os,Es,Ws,Ar={focus:!0};function i_(_){if(_!=Ws){let b=_==null,P=Ot.alpha!=1;v.forEach((L,B)=>{if(s==1||B>0){let Y=b||B==0||B==_;L._focus=b?null:Y,P&&e_(B,Y?1:Ot.alpha)}}),Ws=_,P&&Li()}}tt&&Jt&&_e(Hf,At,_=>{ut._lock||(Zt(_),Ws!=null&&Vn(null,Ar,!0,li.setSeries))});function Hn(_,b,P){let L=S[b];P&&(_=_/be-(L.ori==1?ne:$t));let B=U;L.ori==1&&(B=Ct,_=B-_),L.dir==-1&&(_=B-_);let Y=L._min,at=L._max,ft=_/B,yt=Y+(at-Y)*ft,Nt=L.distr;return Nt==3?Or(10,yt):Nt==4?tx(yt,L.asinh):Nt==100?L.bwd(yt):yt}function n_(_,b){let P=Hn(_,T,b);return An(P,t[0],ti,ei)}i.valToIdx=_=>An(_,t[0]),i.posToIdx=n_,i.posToVal=Hn,i.valToPos=(_,b,P)=>S[b].ori==0?r(_,S[b],P?W:U,P?R:0):o(_,S[b],P?ht:Ct,P?M:0),i.setCursor=(_,b,P)=>{ke=_.left,We=_.top,Xs(null,b,P)};function gf(_,b){Ve(Tr,Dr,Be.left=_),Ve(Tr,Fo,Be.width=b)}function _f(_,b){Ve(Tr,"top",Be.top=_),Ve(Tr,Uo,Be.height=b)}let To=I.ori==0?gf:_f,Ao=I.ori==1?gf:_f;function s_(){if(tt&&dt.live)for(let _=s==2?1:0;_<v.length;_++){if(_==0&&re)continue;let b=dt.values[_],P=0;for(let L in b)Vt[_][P++].firstChild.nodeValue=b[L]}}function Oh(_,b){if(_!=null&&(_.idxs?_.idxs.forEach((P,L)=>{st[L]=P}):sx(_.idx)||st.fill(_.idx),dt.idx=st[0]),tt&&dt.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!re)&&r_(P,st[P]);s_()}pt=!1,b!==!1&&wi("setLegend")}i.setLegend=Oh;function r_(_,b){let P=v[_],L=_==0&&V==2?Yi:t[_],B;re?B=P.values(i,_,b)??te:(B=P.value(i,b==null?null:L[b],_,b),B=B==null?te:{_:B}),dt.values[_]=B}function Xs(_,b,P){pf=ke,mf=We,[ke,We]=ut.move(i,ke,We),ut.left=ke,ut.top=We,mt&&(Sr&&Xn(Sr,_i(ke),0,U,Ct),br&&Xn(br,0,_i(We),U,Ct));let L,B=ti>ei;os=Ne,Es=null;let Y=I.ori==0?U:Ct,at=I.ori==1?U:Ct;if(ke<0||Ze==0||B){L=ut.idx=null;for(let ft=0;ft<v.length;ft++){let yt=se[ft];yt!=null&&Xn(yt,-10,-10,U,Ct)}Jt&&Vn(null,Ar,!0,_==null&&li.setSeries),dt.live&&(st.fill(L),pt=!0)}else{let ft,yt,Nt;s==1&&(ft=I.ori==0?ke:We,yt=Hn(ft,T),L=ut.idx=An(yt,t[0],ti,ei),Nt=G(t[0][L],I,Y,0));let Dt=-10,Ut=-10,ee=0,Se=0,ye=!0,ue="",qt="";for(let Wt=s==2?1:0;Wt<v.length;Wt++){let ze=v[Wt],Ke=st[Wt],Ei=Ke==null?null:s==1?t[Wt][Ke]:t[Wt][1][Ke],Pe=ut.dataIdx(i,Wt,L,yt),je=Pe==null?null:s==1?t[Wt][Pe]:t[Wt][1][Pe];if(pt=pt||je!=Ei||Pe!=Ke,st[Wt]=Pe,Wt>0&&ze.show){let Zi=Pe==null?-10:Pe==L?Nt:G(s==1?t[0][Pe]:t[Wt][0][Pe],I,Y,0),Bi=je==null?-10:D(je,s==1?S[ze.scale]:S[ze.facets[1].scale],at,0);if(Jt&&je!=null){let un=I.ori==1?ke:We,wn=xi(Ot.dist(i,Wt,Pe,Bi,un));if(wn<os){let Gn=Ot.bias;if(Gn!=0){let Ji=Hn(un,ze.scale),dn=je>=0?1:-1,En=Ji>=0?1:-1;En==dn&&(En==1?Gn==1?je>=Ji:je<=Ji:Gn==1?je<=Ji:je>=Ji)&&(os=wn,Es=Wt)}else os=wn,Es=Wt}}if(pt||Rt){let un,wn;I.ori==0?(un=Zi,wn=Bi):(un=Bi,wn=Zi);let Gn,Ji,dn,En,Wn,zi,Ki=!0,$s=lt.bbox;if($s!=null){Ki=!1;let Vi=$s(i,Wt);dn=Vi.left,En=Vi.top,Gn=Vi.width,Ji=Vi.height}else dn=un,En=wn,Gn=Ji=lt.size(i,Wt);if(zi=lt.fill(i,Wt),Wn=lt.stroke(i,Wt),Rt)Wt==Es&&os<=Ot.prox&&(Dt=dn,Ut=En,ee=Gn,Se=Ji,ye=Ki,ue=zi,qt=Wn);else{let Vi=se[Wt];Vi!=null&&(Oe[Wt]=dn,Oi[Wt]=En,Zf(Vi,Gn,Ji,Ki),qf(Vi,zi,Wn),Xn(Vi,xn(dn),xn(En),U,Ct))}}}}if(Rt){let Wt=Ot.prox,ze=Ws==null?os<=Wt:os>Wt||Es!=Ws;if(pt||ze){let Ke=se[0];Ke!=null&&(Oe[0]=Dt,Oi[0]=Ut,Zf(Ke,ee,Se,ye),qf(Ke,ue,qt),Xn(Ke,xn(Dt),xn(Ut),U,Ct))}}}if(Be.show&&bs)if(_!=null){let[ft,yt]=li.scales,[Nt,Dt]=li.match,[Ut,ee]=_.cursor.sync.scales,Se=_.cursor.drag;if(Si=Se._x,bi=Se._y,Si||bi){let{left:ye,top:ue,width:qt,height:Wt}=_.select,ze=_.scales[Ut].ori,Ke=_.posToVal,Ei,Pe,je,Zi,Bi,un=ft!=null&&Nt(ft,Ut),wn=yt!=null&&Dt(yt,ee);un&&Si?(ze==0?(Ei=ye,Pe=qt):(Ei=ue,Pe=Wt),je=S[ft],Zi=G(Ke(Ei,Ut),je,Y,0),Bi=G(Ke(Ei+Pe,Ut),je,Y,0),To(Rn(Zi,Bi),xi(Bi-Zi))):To(0,Y),wn&&bi?(ze==1?(Ei=ye,Pe=qt):(Ei=ue,Pe=Wt),je=S[yt],Zi=D(Ke(Ei,ee),je,at,0),Bi=D(Ke(Ei+Pe,ee),je,at,0),Ao(Rn(Zi,Bi),xi(Bi-Zi))):Ao(0,at)}else zh()}else{let ft=xi(pf-df),yt=xi(mf-ff);if(I.ori==1){let ee=ft;ft=yt,yt=ee}Si=Ci.x&&ft>=Ci.dist,bi=Ci.y&&yt>=Ci.dist;let Nt=Ci.uni;Nt!=null?Si&&bi&&(Si=ft>=Nt,bi=yt>=Nt,!Si&&!bi&&(yt>ft?bi=!0:Si=!0)):Ci.x&&Ci.y&&(Si||bi)&&(Si=bi=!0);let Dt,Ut;Si&&(I.ori==0?(Dt=wr,Ut=ke):(Dt=Er,Ut=We),To(Rn(Dt,Ut),xi(Ut-Dt)),bi||Ao(0,at)),bi&&(I.ori==1?(Dt=wr,Ut=ke):(Dt=Er,Ut=We),Ao(Rn(Dt,Ut),xi(Ut-Dt)),Si||To(0,Y)),!Si&&!bi&&(To(0,0),Ao(0,0))}if(Ci._x=Si,Ci._y=bi,_==null){if(P){if(Rf!=null){let[ft,yt]=li.scales;li.values[0]=ft!=null?Hn(I.ori==0?ke:We,ft):null,li.values[1]=yt!=null?Hn(I.ori==1?ke:We,yt):null}Co(Zh,i,ke,We,U,Ct,L)}if(Jt){let ft=P&&li.setSeries,yt=Ot.prox;Ws==null?os<=yt&&Vn(Es,Ar,!0,ft):os>yt?Vn(null,Ar,!0,ft):Es!=Ws&&Vn(Es,Ar,!0,ft)}}pt&&(dt.idx=L,Oh()),b!==!1&&wi("setCursor")}let Ts=null;Object.defineProperty(i,"rect",{get(){return Ts==null&&Ro(!1),Ts}});function Ro(_=!1){_?Ts=null:(Ts=g.getBoundingClientRect(),wi("syncRect",Ts))}function xf(_,b,P,L,B,Y,at){ut._lock||bs&&_!=null&&_.movementX==0&&_.movementY==0||(kh(_,b,P,L,B,Y,at,!1,_!=null),_!=null?Xs(null,!0,!0):Xs(b,!0,!1))}function kh(_,b,P,L,B,Y,at,ft,yt){if(Ts==null&&Ro(!1),Zt(_),_!=null)P=_.clientX-Ts.left,L=_.clientY-Ts.top;else{if(P<0||L<0){ke=-10,We=-10;return}let[Nt,Dt]=li.scales,Ut=b.cursor.sync,[ee,Se]=Ut.values,[ye,ue]=Ut.scales,[qt,Wt]=li.match,ze=b.axes[0].side%2==1,Ke=I.ori==0?U:Ct,Ei=I.ori==1?U:Ct,Pe=ze?Y:B,je=ze?B:Y,Zi=ze?L:P,Bi=ze?P:L;if(ye!=null?P=qt(Nt,ye)?a(ee,S[Nt],Ke,0):-10:P=Ke*(Zi/Pe),ue!=null?L=Wt(Dt,ue)?a(Se,S[Dt],Ei,0):-10:L=Ei*(Bi/je),I.ori==1){let un=P;P=L,L=un}}yt&&(b==null||b.cursor.event.type==Zh)&&((P<=1||P>=U-1)&&(P=Ys(P,U)),(L<=1||L>=Ct-1)&&(L=Ys(L,Ct))),ft?(df=P,ff=L,[wr,Er]=ut.move(i,P,L)):(ke=P,We=L)}let Bh={width:0,height:0,left:0,top:0};function zh(){Na(Bh,!1)}let vf,yf,Mf,Sf;function bf(_,b,P,L,B,Y,at){bs=!0,Si=bi=Ci._x=Ci._y=!1,kh(_,b,P,L,B,Y,at,!0,!1),_!=null&&(_e(Jh,eu,wf,!1),Co(zf,i,wr,Er,U,Ct,null));let{left:ft,top:yt,width:Nt,height:Dt}=Be;vf=ft,yf=yt,Mf=Nt,Sf=Dt}function wf(_,b,P,L,B,Y,at){bs=Ci._x=Ci._y=!1,kh(_,b,P,L,B,Y,at,!1,!0);let{left:ft,top:yt,width:Nt,height:Dt}=Be,Ut=Nt>0||Dt>0,ee=vf!=ft||yf!=yt||Mf!=Nt||Sf!=Dt;if(Ut&&ee&&Na(Be),Ci.setScale&&Ut&&ee){let Se=ft,ye=Nt,ue=yt,qt=Dt;if(I.ori==1&&(Se=yt,ye=Dt,ue=ft,qt=Nt),Si&&ws(T,Hn(Se,T),Hn(Se+ye,T)),bi)for(let Wt in S){let ze=S[Wt];Wt!=T&&ze.from==null&&ze.min!=Ne&&ws(Wt,Hn(ue+qt,Wt),Hn(ue,Wt))}zh()}else ut.lock&&(ut._lock=!ut._lock,Xs(b,!0,_!=null));_!=null&&(pi(Jh,eu),Co(Jh,i,ke,We,U,Ct,null))}function o_(_,b,P,L,B,Y,at){if(ut._lock)return;Zt(_);let ft=bs;if(bs){let yt=!0,Nt=!0,Dt=10,Ut,ee;I.ori==0?(Ut=Si,ee=bi):(Ut=bi,ee=Si),Ut&&ee&&(yt=ke<=Dt||ke>=U-Dt,Nt=We<=Dt||We>=Ct-Dt),Ut&&yt&&(ke=ke<wr?0:U),ee&&Nt&&(We=We<Er?0:Ct),Xs(null,!0,!0),bs=!1}ke=-10,We=-10,st.fill(null),Xs(null,!0,!0),ft&&(bs=ft)}function Ef(_,b,P,L,B,Y,at){ut._lock||(Zt(_),Eo(),zh(),_!=null&&Co(Gf,i,ke,We,U,Ct,null))}function Tf(){A.forEach(yv),F(i.width,i.height,!0)}Ks(Wa,Ur,Tf);let Rr={};Rr.mousedown=bf,Rr.mousemove=xf,Rr.mouseup=wf,Rr.dblclick=Ef,Rr.setSeries=(_,b,P,L)=>{let B=li.match[2];P=B(i,b,P),P!=-1&&Vn(P,L,!0,!1)},mt&&(_e(zf,g,bf),_e(Zh,g,xf),_e(Vf,g,_=>{Zt(_),Ro(!1)}),_e(Hf,g,o_),_e(Gf,g,Ef),cu.add(i),i.syncRect=Ro);let Da=i.hooks=n.hooks||{};function wi(_,b,P){ki?Re.push([_,b,P]):_ in Da&&Da[_].forEach(L=>{L.call(null,i,b,P)})}(n.plugins||[]).forEach(_=>{for(let b in _.hooks)Da[b]=(Da[b]||[]).concat(_.hooks[b])});let Af=(_,b,P)=>P,li=ui({key:null,setSeries:!1,filters:{pub:tp,sub:tp},scales:[T,v[1]?v[1].scale:null],match:[ep,ep,Af],values:[null,null]},ut.sync);li.match.length==2&&li.match.push(Af),ut.sync=li;let Rf=li.key,Vh=Kp(Rf);function Co(_,b,P,L,B,Y,at){li.filters.pub(_,b,P,L,B,Y,at)&&Vh.pub(_,b,P,L,B,Y,at)}Vh.sub(i);function a_(_,b,P,L,B,Y,at){li.filters.sub(_,b,P,L,B,Y,at)&&Rr[_](null,b,P,L,B,Y,at)}i.pub=a_;function l_(){Vh.unsub(i),cu.delete(i),Mi.clear(),su(Wa,Ur,Tf),l.remove(),At?.remove(),wi("destroy")}i.destroy=l_;function Hh(){wi("init",n,t),wo(t||n.data,!1),H[T]?Dh(T,H[T]):Eo(),nt=Be.show&&(Be.width>0||Be.height>0),et=pt=!0,F(n.width,n.height)}return v.forEach(xr),A.forEach(is),e?e instanceof HTMLElement?(e.appendChild(l),Hh()):e(i,Hh):Hh(),i}Ii.assign=ui;Ii.fmtNum=gu;Ii.rangeNum=Xa;Ii.rangeLog=Ya;Ii.rangeAsinh=pu;Ii.orient=Qs;Ii.pxRatio=be;Ii.join=ux;Ii.fmtDate=xu,Ii.tzDate=Sx;Ii.sync=Kp;{Ii.addGap=sv,Ii.clipGaps=Ka;let n=Ii.paths={points:nm};n.linear=rm,n.stepped=av,n.bars=lv,n.spline=hv}var Mv=3,cm=n=>getComputedStyle(document.documentElement).getPropertyValue(n).trim(),Wr=class{constructor(t,e,i){this.host=t,this.series=i,this.low=null,this.high=null;let s=()=>cm("--faint"),r={stroke:()=>cm("--line"),width:1},o="11px system-ui, sans-serif";this.uplot=new Ii({width:100,height:100,pxAlign:!1,cursor:{drag:{x:!1,y:!1},points:{size:6},sync:{key:"ropewalk"}},legend:{live:!0},scales:{x:{time:!1,auto:!1,range:(a,c,l)=>[c,l]},y:{range:()=>bv(this.low,this.high)}},axes:[{stroke:s,grid:r,ticks:{...r,size:4},font:o,size:24,values:(a,c)=>c.map(l=>`${Xe(l)} s`)},{stroke:s,grid:r,ticks:{...r,size:4},font:o,size:52,space:20,values:(a,c)=>c.map(l=>gi(l,e))}],series:[{label:"time",value:(a,c)=>c===null?"":`${c.toFixed(2)} s`},...i.map(({label:a,colour:c})=>({label:a,stroke:c,width:1.6,points:{show:!1},gaps:wv,value:(l,h)=>h===null?"":gi(h,e)}))]},[[],...i.map(()=>[])],t),this.resize()}resize(){let t=this.host.querySelector(".u-legend"),e=t instanceof HTMLElement?t.offsetHeight:24,i=this.host.clientWidth,s=Math.max(60,this.host.clientHeight-e-2);i>40&&(this.uplot.width!==i||this.uplot.height!==s)&&this.uplot.setSize({width:i,height:s})}show(t,e,i){[this.low,this.high]=Sv(t),this.uplot.batch(()=>{this.uplot.setData(t,!1),this.uplot.setScale("x",{min:e,max:i})})}destroy(){this.uplot.destroy()}};function Sv([,...n]){let[t,e]=[1/0,-1/0];for(let i of n)for(let s of i)Number.isFinite(s)&&(s<t&&(t=s),s>e&&(e=s));return t<=e?[t,e]:[null,null]}function bv(n,t){if(n===null||t===null||!Number.isFinite(n)||!Number.isFinite(t))return[0,1];let e=Math.max(.08*(t-n),.01*Math.max(Math.abs(n),Math.abs(t)),1e-9);return[n-e,t+e]}function wv(n,t,e,i){let[s,r]=[n.data[0],n.data[t]],o=a=>n.valToPos(s[a],"x",!0);return Ev(s,r,e,i).map(([a,c])=>[o(a),o(c)])}function Ev(n,t,e,i){let s=[],r=-1;for(let o=e;o<=i;o++)Number.isFinite(t[o])&&(r>=0&&(o>r+1||n[o]-n[r]>Mv)&&s.push([r,o]),r=o);return s}function el(n,t,e){let i=t.parts[0],s=n.scalars.map((l,h)=>[l,i.scalars[h]]),[r,o,a]=n.up,c=gn(n,i,"speed_high");for(let l of e){let[h,u,d]=i.positions.subarray(3*l,3*l+3);s.push([`height ${l}`,h*r+u*o+d*a]),s.push([`speed ${l}`,i.speed[l]/65535*c]),s.push([`tension ${l}`,Ff(n,i,Tv(n,l))])}return n.variants.slice(1).forEach((l,h)=>{s.push([`difference ${h+1}`,gn(n,t.parts[h+1],"difference")])}),s}function Tv(n,t){for(let{first:e,nodes:i}of n.variants[0].ropes)if(t>=e&&t<e+i)return Math.max(e,Math.min(t,e+i-2));return t}var Eu=[2,5,10,30,60,1/0],Av=66,hm={energies:"Energies",tension:"Tension",motion:"Height or speed",phase:"Phase plane",difference:"Difference"},Rv=[["kinetic","kinetic",Qe[0]],["gravity","gravity",Qe[2]],["elastic","elastic",Qe[1]],["lost","lost",Qe[3]]],il=class{constructor(t,e){this.stage=t,this.host=e,this.history=new ka,this.window=10,this.back=0,this.wanted=()=>{},this.quantity="height",this.panels=new Map,this.lastDraw=0,this.soon=!1,this.turn=0,this.plots=X("div",{className:"plots"}),this.chips=X("div",{className:"chips"}),this.scroll=X("input",{type:"range",id:"graph-scroll",min:"0",max:"0",step:"any","aria-label":"Scroll back in time",oninput:()=>{this.back=Number(this.scroll.max)-Number(this.scroll.value),this.drawAll()}}),this.windowChoice=X("select",{id:"graph-window","aria-label":"Seconds shown",onchange:()=>this.setWindow(Number(this.windowChoice.value.replace("all","Infinity")))},...Eu.map(s=>X("option",{value:Number.isFinite(s)?String(s):"all",selected:s===this.window},Number.isFinite(s)?`${s} s`:"all"))),this.quantityChoice=X("select",{id:"graph-quantity","aria-label":"Height or speed",onchange:()=>this.setQuantity()},X("option",{value:"height"},"Height"),X("option",{value:"speed"},"Speed")),e.append(X("div",{className:"graph-bar"},this.chips,this.quantityChoice,X("label",{},"Last",this.windowChoice),this.scroll),this.plots);let i=matchMedia("(max-width: 700px)").matches;this.shown=new Set(i?["energies"]:["energies","tension","motion"]),t.session.on("frame",s=>this.take(s)),t.session.on("layout",()=>this.rebuild()),t.session.on("status",()=>this.bounds()),new ResizeObserver(()=>this.resize()).observe(this.plots),this.plots.addEventListener("wheel",s=>this.wheel(s),{passive:!1})}get open(){return!this.host.hidden}toggle(t=!this.open){this.host.hidden=!t,t?this.rebuild():this.clear()}take(t){let{layout:e}=this.stage.session;if(!e)return;if(t.flags&2&&this.stage.session.hello?.mode==="replay"){this.drawSoon();return}if(this.history.add(t.time,el(e,t,this.stage.marks.followed)),!this.open)return;if(!(t.flags&1)){this.drawSoon();return}let i=performance.now();if(i-this.lastDraw<Av/Math.max(1,this.panels.size))return;this.lastDraw=i;let s=[...this.panels.values()];this.turn=(this.turn+1)%Math.max(1,s.length),s[this.turn]&&this.draw(s[this.turn]),this.turn===0&&this.bounds()}clear(){for(let{plot:t,box:e}of this.panels.values())t instanceof Wr&&t.destroy(),e.remove();this.panels.clear()}rebuild(){if(!this.open)return;this.clear();let t=(this.stage.session.layout?.variants.length??1)>1,e=Object.keys(hm).filter(i=>i!=="difference"||t);this.chips.replaceChildren(...e.map(i=>this.chip(i))),this.quantityChoice.hidden=!this.shown.has("motion");for(let i of e){if(!this.shown.has(i))continue;let s=X("div",{className:"plot",data:{kind:i}});this.plots.append(s),this.panels.set(i,{kind:i,box:s,plot:null})}for(let i of this.panels.values())i.plot=this.make(i);requestAnimationFrame(()=>this.resize()),this.bounds(),this.wanted()}get span(){return Number.isFinite(this.window)?this.window:Math.max(Eu[0],this.history.last-this.history.first)||Eu[0]}chip(t){return X("button",{type:"button",className:"chip","aria-pressed":String(this.shown.has(t)),data:{graph:t},onclick:()=>{matchMedia("(max-width: 700px)").matches&&this.shown.clear(),this.shown.delete(t)||this.shown.add(t),this.rebuild()}},hm[t])}make({kind:t,box:e}){if(t==="phase")return new Ba(e);let i={energies:"J",tension:"N",motion:this.quantity==="height"?"m":"m/s",difference:"m"}[t];return new Wr(e,i,this.series(t))}series(t){if(t==="energies")return Rv.map(([r,o,a])=>({name:r,label:o,colour:a}));let e=this.stage.session.layout?.variants??[];if(t==="difference")return e.slice(1).map((r,o)=>({name:`difference ${o+1}`,label:`${r.label}, rms`,colour:Qe[(o+1)%Qe.length]}));let i=t==="tension"?"tension":this.quantity,s=[...this.stage.marks.followed].map((r,o)=>({name:`${i} ${r}`,label:this.nodeName(r),colour:Qe[(o+1)%Qe.length]}));return t==="tension"?[{name:"tension_max",label:"largest",colour:Qe[0]},...s]:this.quantity==="speed"?[{name:"speed_high",label:"fastest",colour:Qe[0]},...s]:s.length?s:[{name:"high",label:"highest",colour:Qe[0]},{name:"low",label:"lowest",colour:Qe[5]}]}nodeName(t){let e=this.stage.session.layout?.variants[0].ropes??[],i=e.find(({first:s,nodes:r})=>t>=s&&t<s+r);return e.length>1&&i?`${i.name} ${t-i.zero}`:`node ${t-(i?.zero??0)}`}draw({kind:t,plot:e}){if(!Number.isFinite(this.history.last))return;let i=Math.max(this.history.last-this.back-this.span,this.history.first),s=i+this.span;if(e instanceof Wr){let r=e.series.map(({name:o})=>o);e.show(this.history.between(i,s,r),i,s)}else if(e&&t==="phase"){let r=[...this.stage.marks.followed][0],[o,a]=this.history.between(i,s,[`height ${r}`]);e.show(o,a,Qe[1])}}drawSoon(){this.soon||(this.soon=!0,requestAnimationFrame(()=>{this.soon=!1,this.bounds(),this.drawAll()}))}drawAll(){for(let t of this.panels.values())this.draw(t)}bounds(){let t=this.stage.session.status?.playing??!0,e=Math.max(0,this.history.last-this.history.first-this.span)||0;t&&(this.back=0),this.scroll.disabled=t||e===0,this.scroll.title=t?"Pause to scroll back":"Scroll back in time",this.scroll.max=String(e),this.scroll.value=String(e-this.back),t||this.drawAll()}wheel(t){if(this.scroll.disabled)return;t.preventDefault();let e=(t.deltaX||t.deltaY)/400*this.span;this.back=Math.min(Number(this.scroll.max),Math.max(0,this.back-e)),this.bounds()}setWindow(t){this.window=t,this.back=0,this.wanted(),this.bounds(),this.drawAll()}setQuantity(){this.quantity=this.quantityChoice.value,this.rebuild()}resize(){for(let{plot:t}of this.panels.values())t?.resize();this.drawAll()}};var nl=class{constructor(t,e){this.name=X("span",{className:"scene-name"},"…"),this.choose=X("button",{type:"button",className:"scene-choice",id:"open-scenes",title:"Scenes",onclick:e.scenes},this.name,mn("down")),this.tour=Ni("tour","Guided tour",e.tour,{words:"Tour",id:"open-tour"}),this.compare=Ni("compare","Compare copies",e.compare,{words:"Compare",id:"open-compare"}),this.keep=Ni("keep","Save, export, link",()=>e.keep(this.keep),{words:"Keep",id:"open-keep"}),this.panel=Ni("panel","Panel of constants",e.panel,{key:"P",id:"toggle-panel"}),t.append(X("strong",{className:"brand"},"Ropewalk"),this.choose,X("span",{className:"gap"}),this.tour,this.compare,this.keep,Ni("help","Help",e.help,{key:"H",id:"open-help"}),Ni("theme","Light or dark",e.theme,{key:"T",id:"toggle-theme"}),this.panel)}show(t){this.name.textContent=t,this.choose.setAttribute("aria-label",`Scene: ${t}. Choose another`),document.title=`${t} – Ropewalk`}};var Cv=300,Pv=3,Iv={back:"Back to before",step:"Use the suggested step",implicit:"Use an implicit method",on:"Go on with these values"},sl=class{constructor(t,e,i){this.session=t,this.draw=i,this.timer=0,this.card=X("section",{className:"card broken",hidden:!0,role:"alert",id:"broken"}),e.append(this.card),t.on("broken",s=>this.show(s)),t.on("frame",({flags:s})=>this.tellReplay((s&2)!==0))}tellReplay(t){let{hello:e,layout:i}=this.session;e?.mode!=="replay"||this.card.hidden!==t||(this.card.hidden=!t,!(!t||!i?.broke)&&this.card.replaceChildren(X("h2",{},"The run broke"),X("p",{},i.broke.text||`It broke after t = ${Xe(i.broke.time)} s.`),X("p",{className:"faint"},"Shown: steps past the last good frame. No number counts them.")))}show(t){if(this.card.hidden=t===null,clearTimeout(this.timer),!t)return;let e=t.remedies.map((i,s)=>X("button",{type:"button",className:s===0?"main":"second",data:{remedy:i.id},onclick:()=>this.session.tell({type:"remedy",remedy:i.id})},i.label||Iv[i.id]));this.card.replaceChildren(X("h2",{},"The simulation broke"),X("p",{},t.text),X("div",{className:"row"},...e,...this.look(t)))}look(t){let{past:e}=t;if(!e?.length)return[];let i=X("span",{className:"faint",id:"past"}),s=o=>{let a=e[Math.min(o,e.length-1)],c=o===e.length+Pv;this.draw(c?null:a.positions,t.variant),i.textContent=c?"":`${a.time.toFixed(5)} s: past the last good state`,c||(this.timer=window.setTimeout(()=>s(o+1),Cv))};return[X("button",{type:"button",className:"second",id:"see-break",onclick:()=>{clearTimeout(this.timer),s(0)}},"See it break"),i]}};function Tu(n){let t=[],e=0;for(let i of n.variants)t.push(e),e+=i.nodes;return t}var Cn=n=>n.variants.reduce((t,e)=>t+e.nodes,0);function Xr(n,t,e){let i=n.variants.length>1?t:n.variants[t].ropes[e].color;return qs(Qe[i%Qe.length])}function um(n){let t=Tu(n),e=[];return n.variants.forEach((i,s)=>{i.ropes.forEach((r,o)=>{e.push({name:r.name,first:t[s]+r.first,count:r.nodes,radius:r.diameter/2,spacing:r.length/Math.max(1,r.segments),colour:Xr(n,s,o)})})}),{nodes:Cn(n),ropes:e}}function dm(n,t,e,i){return n.variants.map((s,r)=>ci(e,t?r*i:0))}function fm(n,t){let{low:e,high:i}=n,r=n.scale==="log"&&e>0?e*(i/e)**t:e+t*(i-e);return n.whole?Math.round(r):Number(r.toPrecision(3))}function pm(n,t){let{low:e,high:i}=n,r=n.scale==="log"&&e>0?Math.log(Math.max(t,e)/e)/Math.log(i/e):(t-e)/(i-e);return Math.min(1,Math.max(0,Number.isFinite(r)?r:0))}function tr(n){let t=n.trim().replace(",",".").replace("−","-");return t===""?NaN:Number(t)}function $r(n,t=11){let e=String(Number(n.toPrecision(6)));return e.length<=t?e:Number(n.toPrecision(t-5)).toExponential()}var Lv=["bdf2","rk4"],Nv=3,rl=class{constructor(t,e,i,s){this.stage=t,this.colours=s,this.changes=[],this.rows=X("div",{className:"compare-rows"}),this.fault=X("p",{className:"fault",hidden:!0,role:"alert"}),this.add=X("button",{type:"button",className:"second",onclick:()=>this.addRow()},"One more copy"),this.apart=X("select",{id:"compare-way","aria-label":"How copies are shown",onchange:()=>this.stage.setApart(this.apart.value==="apart")},X("option",{value:"over"},"overlaid"),X("option",{value:"apart"},"side by side")),this.stop=X("button",{type:"button",className:"second",id:"compare-end",onclick:()=>this.end()},"End the comparison"),this.window=Lr("Compare","compare",X("p",{},"Copies of this scene run beside it with one constant changed, moved by the same hand."),this.rows,this.fault,X("div",{className:"row"},this.add,X("span",{className:"gap"}),this.stop,X("button",{type:"button",className:"main",id:"compare-start",onclick:()=>this.start()},"Compare"))),e.append(this.window),this.lines=X("div",{}),this.card=X("div",{className:"card difference",hidden:!0,id:"difference"},X("div",{className:"row"},X("strong",{},"Copies"),this.apart,X("button",{type:"button",className:"second small",onclick:()=>this.end()},"End")),this.lines),i.append(this.card),t.card=()=>this.place(),this.lastShown=0,this.wasMany=!1,this.fresh=!1,t.session.on("layout",()=>this.layout()),t.session.on("frame",()=>this.show())}open(){this.changes.length||(this.changes=this.suggested()),this.fill(),this.stop.hidden=!this.wasMany,this.window.showModal()}suggested(){let{parameters:t,status:e,stability:i}=this.stage.session,s=t.find(l=>l.name==="method"),r=i[0]?.steps??{},o=(s?.choices??[]).map(({value:l})=>l),a=l=>(r[l]??1/0)>(e?.dt??0),c=Lv.find(l=>l!==s?.value&&o.includes(l));return c&&a(c)?[{name:"method",value:c}]:e?[{name:"time_step",value:e.dt/2}]:[]}get choices(){return this.stage.session.parameters.filter(t=>t.kind!=="vector"&&t.enabled)}addRow(){let{status:t}=this.stage.session;this.changes.push({name:"time_step",value:t?t.dt/2:.001}),this.fill()}fill(){this.add.disabled=this.changes.length>=Nv,this.rows.replaceChildren(...this.changes.map((t,e)=>this.row(t,e)))}row(t,e){let i=this.choices.find(o=>o.name===t.name)??this.choices[0],s=X("select",{"aria-label":`What copy ${e+1} changes`,onchange:()=>{let o=this.choices.find(a=>a.name===s.value);this.changes[e]={name:s.value,value:o?.value},this.fill()}},...this.choices.map(o=>X("option",{value:o.name,selected:o===i},o.label))),r=X("button",{type:"button",className:"second small","aria-label":`Remove copy ${e+1}`,onclick:()=>{this.changes.splice(e,1),this.fill()}},"Remove");return X("div",{className:"row"},s,this.valueField(i,t),r)}valueField(t,e){if(t.kind==="choice"||t.kind==="flag"){let s=t.choices??[!0,!1].map(o=>({value:o,label:o?"yes":"no"})),r=X("select",{"aria-label":t.label,onchange:()=>e.value=s[r.selectedIndex].value},...s.map(({value:o,label:a})=>X("option",{selected:o===e.value},a)));return r.selectedIndex>=0&&(e.value=s[r.selectedIndex].value),r}let i=X("input",{type:"text",inputMode:"decimal","aria-label":t.label,value:typeof e.value=="number"?$r(e.value):"",oninput:()=>e.value=tr(i.value)});return X("label",{},i,Pr(t.unit))}label({name:t,value:e}){let i=this.stage.session.parameters.find(s=>s.name===t);return i?.kind==="choice"||typeof e!="number"?String(e):`${i?.label??t} ${gi(e,i?.unit)}`}async start(){let t=this.changes.map(e=>({label:this.label(e),changes:{[e.name]:e.value}}));try{await this.stage.session.ask({type:"compare",variants:t}),this.fault.hidden=!0,this.window.close()}catch(e){this.fault.textContent=e.text,this.fault.hidden=!1}}async end(){this.window.close(),await this.stage.session.tell({type:"compare",variants:[]})}layout(){let t=this.stage.session.layout,e=t.variants.length>1;this.card.hidden=!e,e!==this.wasMany&&this.colours(e),e&&!this.wasMany&&(this.fresh=!0),this.wasMany=e,this.lines.replaceChildren(...t.variants.map((i,s)=>{let r=X("i",{});return r.style.background=hi(Xr(t,s,0)),X("div",{className:"line"},r,X("span",{},i.label),X("output",{}))}))}place(){if(!this.card.getClientRects().length)return null;let{x:t,y:e,width:i,height:s}=this.card.getBoundingClientRect(),r=this.stage.renderer.canvas.getBoundingClientRect();return new DOMRect(t-r.x,e-r.y,i,s)}show(){let{layout:t,frame:e}=this.stage.session,i=performance.now();!t||!e||this.card.hidden||i-this.lastShown<200&&!this.fresh||(this.lastShown=i,e.parts.forEach((s,r)=>{let o=this.lines.children[r]?.querySelector("output");if(!o||r===0)return;let a=gi(gn(t,s,"difference"),"m"),c=gi(gn(t,s,"difference_max"),"m");o.textContent=`differs by ${a} rms, ${c} at most`}),this.fresh&&this.stage.uncover(),this.fresh=!1)}};var Dv=100,Au=[.01,.02,.05,.1,.2,.5,1,2,4],mm=n=>n>=.995?`${Xe(n)}×`:`1/${Xe(1/n)}×`,ol=class{constructor(t,e,i){this.session=t,this.reset=Ni("reset","Reset to time zero",()=>this.doReset(),{key:"R",id:"reset"}),this.play=Ni("play","Play",()=>this.toggle(),{key:"space",id:"play",kind:"main"}),this.step=Ni("step","One step",()=>this.doStep(),{key:"full stop",id:"step"}),this.clock=X("output",{id:"clock",title:"Simulated time"},"0.00 s"),this.speed=X("input",{type:"range",id:"speed",min:"0",max:String(Au.length-1),step:"1","aria-label":"Speed",oninput:()=>this.setSpeed()}),this.speedText=X("output",{id:"speed-text"},"1×"),this.reached=X("output",{id:"realtime",className:"faint"},""),this.seek=X("input",{type:"range",id:"seek",min:"0",max:"1",step:"any","aria-label":"Time in the recording",oninput:()=>this.doSeek()}),this.graphs=Ni("graph","Graphs",i,{words:"Graphs",key:"G",id:"toggle-graphs"}),this.seeking=0,this.shown=-1/0,e.append(X("div",{className:"group"},this.reset,this.play,this.step),this.clock,this.seek,X("label",{className:"speed",title:"Speed, as a part of real time"},"Speed",this.speed,this.speedText),this.reached,X("span",{className:"gap"}),this.graphs),t.on("hello",()=>this.refresh()),t.on("status",()=>this.refresh()),t.on("frame",s=>this.showTime(s.time)),this.refresh()}refresh(){let{session:t}=this,{status:e}=t;this.play.hidden=!t.can("play"),this.step.hidden=!t.can("step"),this.reset.hidden=!t.can("reset");let i=this.speed.parentElement;if(i.hidden=!t.can("speed"),this.seek.hidden=!t.can("seek")||!e?.duration,!e)return;!e.playing&&t.frame&&this.showTime(t.frame.time),this.play.disabled=e.broken,this.step.disabled=e.broken||e.playing;let s=e.playing?"pause":"play";if(this.play.dataset.shows!==s){this.play.dataset.shows=s,this.play.replaceChildren(mn(s,s==="play"));let r=e.playing?"Pause":"Play";this.play.title=`${r} (space)`,this.play.setAttribute("aria-label",r)}document.activeElement!==this.speed&&(this.speed.value=String(Fv(e.speed))),this.speedText.textContent=mm(e.speed),this.reached.textContent=e.playing?`reached ${Xe(e.realtime)}×`:"paused",this.reached.classList.toggle("slow",e.slow),this.reached.title=e.text||"Simulated time per real time, over the last half second",e.duration&&(this.seek.max=String(e.duration))}showTime(t){let e=performance.now();if(e-this.shown>=Dv||!this.session.status?.playing){this.shown=e;let i=`${t.toFixed(2)} s`;this.clock.textContent!==i&&(this.clock.textContent=i)}!this.seek.hidden&&document.activeElement!==this.seek&&(this.seek.value=String(t))}toggle(){let{status:t}=this.session;!t||t.broken||!this.session.can("play")||this.session.tell({type:t.playing?"pause":"play"})}async doStep(){let{status:t}=this.session;!t||t.broken||!this.session.can("step")||(t.playing?await this.session.tell({type:"pause"}):await this.session.tell({type:"step"}))}doReset(){this.session.can("reset")&&this.session.tell({type:"reset"})}setSpeed(){let t=Au[Number(this.speed.value)];this.speedText.textContent=mm(t),this.session.tell({type:"speed",value:t})}doSeek(){cancelAnimationFrame(this.seeking),this.seeking=requestAnimationFrame(()=>{this.session.send({type:"seek",time:Number(this.seek.value)})})}};function Fv(n){let t=Au.map(e=>Math.abs(Math.log(e/n)));return t.indexOf(Math.min(...t))}var Uv=[["Drag an anchor (square)","it follows the hand, in the plane parallel to the screen"],["Drag the rope","by a soft spring; its force is shown in newtons"],["Hold Shift at the end of a drag","the spring stays; double-click on empty space lets go"],["Right-click, or a long press","pin, cut, load, kick, follow"],["Drag empty space","turn the view; with Shift or the right button: shift it"],["Wheel, or two fingers","zoom"]],Ov=[["← → ↑ ↓","move the first anchor at 3 m/s"],["Home, End","move it away from you, towards you"],["A D W S Q E","the same for the second anchor"],["J L I K U O","the same for the third anchor"],["Space","play or pause"],[".","one step"],["R","reset to time zero"],["F","show everything"],["G","graphs"],["P","panel of constants"],["T","light or dark"],["H or ?","this help"]],al=class{constructor(t){let e=(i,s)=>X("dl",{},...i.flatMap(([r,o])=>[X("dt",{},X(s,{},r)),X("dd",{},o)]));this.version=X("p",{className:"faint"}),this.window=Lr("Help","help",X("div",{className:"columns"},X("section",{},X("h3",{},"Hand"),e(Uv,"span")),X("section",{},X("h3",{},"Keys"),e(Ov,"kbd"))),this.version),t.append(this.window)}open(){this.window.open?this.window.close():this.window.showModal()}};var kv={"nodes.csv":"Table of nodes (CSV)","energies.csv":"Table of energies (CSV)","tension.csv":"Table of tension (CSV)","scene.toml":"Scene (TOML)","page.html":"Page that replays it (HTML)"},ll=class{constructor(t,e,i){this.stage=t,this.host=e,this.notices=i}open(t){let{session:e}=this.stage,{base:i}=e.source,{hello:s}=e,r=[{label:"Save the run",id:"keep-save",hint:s?.folder??"",show:e.can("save"),press:()=>this.save()},{label:"Copy the link to this set-up",id:"keep-link",show:e.can("scene"),press:()=>this.copyLink()},{label:"Picture (PNG)",id:"keep-png",show:!0,press:()=>this.picture()},...(s?.exports??[]).map(c=>({label:kv[c]??c,id:`keep-${c.replace(".","-")}`,show:!0,press:()=>this.file(`${i}export/${c}`,c)}))],o=t.getBoundingClientRect(),a=this.host.getBoundingClientRect();No(this.host,o.right-a.left-240,o.bottom-a.top+4,r.filter(({show:c})=>c),"Keep")}async save(){await this.stage.session.tell({type:"save"})}async file(t,e){this.notices.say(`Making ${e} …`);try{let i=await fetch(t);if(!i.ok)throw new Error(i.status===404?"it cannot be made here":await i.text());let s=URL.createObjectURL(await i.blob());qh(s,e),setTimeout(()=>URL.revokeObjectURL(s),1e4),this.notices.say(`${e} is in your downloads.`)}catch(i){this.notices.say(`${e}: ${i instanceof Error?i.message:i}`,"fault")}}picture(){this.stage.draw(!0),this.stage.renderer.canvas.toBlob(t=>{if(!t)return;let e=URL.createObjectURL(t);qh(e,`${Bv(this.stage.session.layout?.scene.name??"rope")}.png`),setTimeout(()=>URL.revokeObjectURL(e),1e4)})}async copyLink(){let t=this.stage.session.status,e=`${location.href.split("#")[0]}${t?.address?`#${t.address}`:""}`;try{await navigator.clipboard.writeText(e),this.notices.say("The link is copied. It opens this scene with these constants.")}catch{this.notices.say(e)}}},Bv=n=>n.toLowerCase().replace(/[^a-z0-9]+/g,"-").replace(/^-|-$/g,"")||"rope";function gm([n,t],[e,i],[s,r],o){let a=Math.hypot(e,i),[c,l]=a>1?[e/a,i/a]:[1,0],h=5+Math.min(s/2/Math.abs(c||1e-9),r/2/Math.abs(l||1e-9)),u=[n+c*h,t+l*h],d=s/2+15,f=r/2+15,g=[u,[u[0],u[1]-r],[u[0],u[1]+r],[n,t-f],[n,t+f],[n+d,t],[n-d,t],[n,t-f-1.5*r],[n,t+f+1.5*r]],y=(m,p)=>Math.max(2,Math.min(m,p-2));return g.map(([m,p])=>({x:y(m-s/2,o[0]-s),y:y(p-r/2,o[1]-r),width:s,height:r}))}function Ru(n,t,e){return!t.some(i=>zv(n,i))&&!e.some(([i,s])=>i>n.x&&i<n.x+n.width&&s>n.y&&s<n.y+n.height)}function zv(n,t){return n.x<t.x+t.width&&t.x<n.x+n.width&&n.y<t.y+t.height&&t.y<n.y+n.height}var Vv=7.4,Hv=20,cl=10,Gv=90,Wv=".toolbar, .legend, .difference, .tour, .broken, .slow-note, .banner",Xv=100,$v=1e3,hl=class{constructor(t,e){this.stage=t,this.host=e,this.box=X("div",{className:"labels","aria-hidden":"true"}),this.pool=[],this.taken=[],this.cards=[],this.watched=new Set,this.looked=this.worded=-1/0,this.watch=new ResizeObserver(()=>{this.looked=-1/0,t.marks.dirty=!0}),this.watch.observe(e),e.append(this.box),t.afterDraw.push(()=>this.refresh())}refresh(){let{labels:t}=this.stage.marks;for(;this.pool.length<t.length;){let a=X("span",{});this.pool.push(a),this.box.append(a)}let e=t.map(a=>this.plate(a)),i=t.length?[...this.cardsNow(),...e]:[],s=t.length?this.beads():[],r=performance.now(),o=r-this.worded>=Xv||!this.stage.session.status?.playing;o&&(this.worded=r),this.pool.forEach((a,c)=>{let l=t[c],u=o||a.hidden||a.className!==l?.kind?l?.text:a.textContent,d=l?this.place({...l,text:u??""},c,i,s):null;a.hidden===(d!==null)&&(a.hidden=!a.hidden),d&&(i.push(d),a.textContent!==u&&(a.textContent=u??""),a.className!==l.kind&&(a.className=l.kind),a.style.transform=`translate(${Math.round(d.x)}px, ${Math.round(d.y)}px)`)})}place({from:t,at:e,text:i},s,r,o){let{camera:a}=this.stage,[c,l,h]=a.project(...e);if(!(h>0))return null;let[u,d]=a.project(...t),f=[Vv*i.length+14,Hv],g=[a.width,a.height],y=gm([c,l],[c-u,l-d],f,g),p=[this.taken[s]??0,...y.keys()],v=p.find(S=>Ru(y[S],r,o)),A=v??p.find(S=>Ru(y[S],r,[]));return A===void 0?null:(this.taken[s]=v===void 0?0:A,y[A])}plate({from:t}){let[e,i]=this.stage.camera.project(...t);return{x:e-cl,y:i-cl,width:2*cl,height:2*cl}}beads(){let{camera:t,nodes:e,session:i}=this.stage,s=i.layout?Cn(i.layout):0,r=Math.max(1,Math.ceil(s/Gv)),o=[];for(let a=0;a<s;a+=r){let[c,l,h]=e.shown.subarray(4*a,4*a+3);o.push(t.project(c,l,h))}return o}cardsNow(){let t=performance.now();if(t-this.looked<$v)return this.cards;this.looked=t;let{left:e,top:i}=this.host.getBoundingClientRect();return this.cards=[...this.host.querySelectorAll(Wv)].map(s=>{this.watched.has(s)||this.watch.observe(s),this.watched.add(s);let{x:r,y:o,width:a,height:c}=s.getBoundingClientRect();return{x:r-e,y:o-i,width:a,height:c}}),this.cards}};var qv=100,Yv=2e-9;function Zv(n,t){return n==="strain"?["%",100]:n==="speed"?["m/s",1]:t>=1e7?["MN",1e-6]:t>=1e4?["kN",.001]:["N",1]}var ul=class{constructor(t,e){this.stage=t,this.written=-1/0,this.select=X("select",{id:"colouring","aria-label":"Colour of the ropes",onchange:()=>this.choose()},X("option",{value:"tension"},"Tension"),X("option",{value:"strain"},"Tension / EA"),X("option",{value:"speed"},"Speed"),X("option",{value:"plain"},"Plain colours")),this.bar=X("div",{className:"map"});let i=Ir(),s=Array.from({length:17},(r,o)=>hi(i[Math.round(o/16*(i.length-1))]));this.bar.style.backgroundImage=`linear-gradient(to right, ${s.join(", ")})`,this.low=X("span",{}),this.middle=X("span",{}),this.high=X("span",{}),this.numbers=X("div",{className:"numbers",id:"legend-numbers"},this.low,this.middle,this.high),this.ropes=X("div",{className:"rope-names"}),this.arrows=this.check("Forces","show-forces",!0,r=>t.marks.reactions=r),this.dots=this.check("Nodes","show-nodes",!1,r=>t.dots=r),this.grid=X("span",{className:"faint grid-size"}),e.append(X("div",{className:"card legend"},this.select,this.bar,this.numbers,this.ropes,X("div",{className:"row"},this.arrows,this.dots,this.grid))),t.session.on("layout",()=>this.names()),t.session.on("status",()=>this.refresh()),t.afterDraw.push(()=>{(!t.session.status?.playing||performance.now()-this.written>=qv)&&this.refresh()})}check(t,e,i,s){let r=X("input",{type:"checkbox",id:e,checked:i,onchange:()=>{s(r.checked),this.stage.dirty=!0}});return X("label",{},r,t)}choose(){this.stage.setColouring(this.select.value),this.names()}names(){this.written=-1/0;let{layout:t}=this.stage.session,e=this.stage.colouring==="plain";if(this.bar.hidden=this.numbers.hidden=e,this.ropes.replaceChildren(),!t||!e)return;let s=t.variants.length>1?t.variants.map((r,o)=>({name:r.label,colour:Xr(t,o,0)})):t.variants[0].ropes.map((r,o)=>({name:r.name,colour:Xr(t,0,o)}));for(let{name:r,colour:o}of s.slice(0,6)){let a=X("i",{});a.style.background=hi(o),this.ropes.append(X("span",{},a,r))}s.length>6&&this.ropes.append(X("span",{className:"faint"},`and ${s.length-6} more`))}refresh(){this.written=performance.now();let{range:t,colouring:e}=this.stage,{low:i,high:s}=t,[r,o]=Zv(e,Math.max(Math.abs(i),Math.abs(s))),a=l=>Xe(Number((l*o).toPrecision(2))),c=s-i>Yv;if(this.low.hidden=this.middle.hidden=!c,!c)return Ho(this.high,`${a(i)} ${r}`),this.showGrid();Ho(this.low,a(i)),Ho(this.middle,a((i+s)/2)),Ho(this.high,`${a(s)} ${r}`),this.showGrid()}showGrid(){Ho(this.grid,`Grid ${gi(this.stage.spacing,"m")}`)}};function Ho(n,t){n.textContent!==t&&(n.textContent=t)}var Go=1.25,dl=class{constructor(t,e){this.session=t,this.host=e,t.on("stability",i=>this.show(i)),t.on("layout",()=>this.show(t.stability))}show(t){let e=t.length>1;this.host.hidden=t.length===0,this.host.classList.toggle("many",e),this.host.replaceChildren(...t.map((i,s)=>this.row(i,s,e)))}row(t,e,i){let{ratio:s,zone:r}=t,o=this.session.layout?.variants[e]?.label,a=X("div",{className:"fill"});a.style.width=`${100*Math.min(1,(s??0)/Go)}%`;let c=X("div",{className:"tick"});c.style.left=`${100/Go}%`;let l=X("div",{className:"amber-zone"});l.style.left=`${90/Go}%`,l.style.width=`${10/Go}%`;let h=X("div",{className:"red-zone"});h.style.left=`${100/Go}%`;let u=X("div",{className:"meter-bar",role:"meter","aria-label":"Step as a part of the largest stable step","aria-valuemin":"0","aria-valuemax":"1.25","aria-valuenow":String(s??0)},a,l,h,c),d=[];return t.bound!==null&&d.push([`largest step ${gi(t.bound,"s")}`,"step"]),t.largest_spring_constant!==null?d.push([`largest spring constant ${gi(t.largest_spring_constant,"N/m")}`,"k"]):t.largest_axial_stiffness!==null&&d.push([`largest EA ${gi(t.largest_axial_stiffness,"N")}`,"k"]),X("div",{className:`meter-row ${r}`,title:Jv(t),data:{zone:r}},X("span",{className:"meter-name"},i&&o?o:"Stability"),u,X("strong",{className:"meter-ratio"},s===null||t.bound===null?"no bound":Kv(s)),...d.map(([f,g])=>X("span",{className:`meter-fact ${g}`},f)))}};function Jv({verdict:n,meter:t,meter_name:e,meter_limit:i}){return t===null||i===null?n:`${n} (${e} = ${Xe(t)} of ${Xe(i)})`}function Kv(n){return n>=10?`${Xe(n)} times the bound`:`${Xe(100*n)} % of the bound`}var jv=7e3,Qv=3,fl=class{constructor(t,e){this.list=X("div",{className:"notices","aria-live":"polite"}),this.banner=X("div",{className:"banner",hidden:!0,role:"alert",id:"banner"}),this.slow=X("div",{className:"slow-note",hidden:!0,id:"slow"}),e.append(this.banner,this.slow,this.list),t.on("error",i=>this.say(i.text,"fault")),t.on("note",({text:i})=>this.say(i)),t.on("saved",({folder:i})=>this.say(`Saved in ${i}`)),t.on("connection",({state:i,text:s})=>this.connection(i,s)),t.on("status",({slow:i,text:s,broken:r})=>{let o=i&&s!==""&&!r;this.slow.hidden=!o,o&&this.slow.textContent!==s&&(this.slow.textContent=s)})}connection(t,e){if(this.banner.hidden=t==="open",this.banner.classList.toggle("calm",t==="waiting"),document.documentElement.dataset.connection=t,t!=="open")if(t==="damaged")this.banner.replaceChildren(e);else{let i=t==="waiting"?"":" Trying again …";this.banner.replaceChildren(X("span",{className:"spinner"}),`${e}${i}`)}}say(t,e="note"){for(let r of this.list.children)r.firstChild?.textContent===t&&r.remove();let i=X("button",{type:"button",className:"plain","aria-label":"Close",onclick:()=>s.remove()},mn("close")),s=X("div",{className:`notice ${e}`},X("span",{},t),i);for(this.list.append(s);this.list.children.length>Qv;)this.list.firstChild?.remove();setTimeout(()=>s.remove(),jv)}};var pl=class{constructor(t,e){this.session=t,this.list=X("div",{className:"scene-themes"}),this.window=Lr("Scenes","scenes",this.list),e.append(this.window),t.on("presets",()=>this.fill()),t.on("layout",()=>this.mark())}open(){this.mark(),this.window.showModal()}fill(){let{presets:t}=this.session,e=[...new Set(t.map(({theme:i})=>i))];this.list.replaceChildren(...e.flatMap(i=>[X("h3",{},i),X("div",{className:"scene-list"},...t.filter(s=>s.theme===i).map(s=>this.card(s)))])),this.mark()}card(t){let{base:e}=this.session.source,i=X("div",{className:"picture"});return t.picture&&e&&(i.style.maskImage=`url("${new URL(e+t.picture,location.href.split(/[?#]/)[0]).href}")`),X("button",{type:"button",className:"scene-card",data:{preset:t.name},onclick:()=>this.choose(t.name)},i,X("strong",{},t.title),X("span",{},t.sentence))}mark(){let t=this.session.layout?.scene.preset;for(let e of this.list.querySelectorAll(".scene-card"))e instanceof HTMLElement&&e.classList.toggle("now",e.dataset.preset===t)}async choose(t){this.window.close(),await this.session.tell({type:"scene",preset:t})&&this.session.send({type:"play"})}};var _m=[["hand","hand","Hand: drag anchors and ropes",""],["pin","pin","Pin: hold a node where it is, or let it go again","pin"],["cut","cut","Cut a segment","cut"],["load","load","Hang a load on a node","load"],["kick","kick","Kick: draw the velocity from a node","kick"],["follow","follow","Follow a node: its trail and its graphs",""]],ml=class{constructor(t,e,i){this.stage=t,this.host=e,this.follow=i,this.pointer=null,this.mass=1,this.buttons=new Map,this.bar=X("div",{className:"toolbar",role:"toolbar","aria-label":"Tools"});for(let[s,r,o]of _m){let a=Ni(r,o,()=>this.choose(s),{id:`tool-${s}`});this.buttons.set(s,a),this.bar.append(a)}this.massField=X("input",{type:"text",inputMode:"decimal",value:"1",id:"load-mass","aria-label":"Mass to hang [kg]",onchange:()=>{let s=tr(this.massField.value);s>=0&&(this.mass=s),this.massField.value=String(this.mass)}}),this.massBox=X("label",{className:"mass",hidden:!0},this.massField,"kg"),this.bar.append(this.massBox),e.append(this.bar),t.session.on("hello",()=>this.refresh()),this.refresh()}refresh(){for(let[t,,,e]of _m){let i=this.buttons.get(t);i&&(i.hidden=e!==""&&!this.stage.session.can(e))}this.choose(this.pointer?.tool??"hand")}choose(t){this.pointer&&(this.pointer.tool=t);for(let[e,i]of this.buttons)i.setAttribute("aria-pressed",String(e===t));this.massBox.hidden=t!=="load",this.host.dataset.tool=t}use(t,e){let{session:i}=this.stage;t==="pin"?e.kind==="anchor"?i.tell({type:"unpin",anchor:e.anchor}):i.tell({type:"pin",node:e.node}):t==="cut"?i.tell({type:"cut",segment:e.segment}):t==="load"?i.tell({type:"load",node:e.node,mass:this.mass}):t==="follow"&&this.follow(e.node)}menu(t,e,i){let{session:s,marks:r}=this.stage;if(!t){No(this.host,e,i,[{label:"Show everything",press:()=>this.stage.fit()},{label:"Let go of everything",press:()=>s.send({type:"let_go"}),disabled:!s.can("let_go")}]);return}let{node:o}=t,c=(s.layout?.variants[0].loads.filter(f=>f.index===o)??[]).reduce((f,g)=>f+g.mass,0),l=this.stage.camera.up,u=[t.kind==="anchor"?{label:"Let this node go",command:"unpin",press:()=>s.tell({type:"unpin",anchor:t.anchor})}:{label:"Pin it here",command:"pin",press:()=>s.tell({type:"pin",node:o})},{label:"Cut here",command:"cut",press:()=>s.tell({type:"cut",segment:t.segment})},...[1,10].map(f=>({label:`Hang ${f} kg here`,command:"load",press:()=>s.tell({type:"load",node:o,mass:f})})),...c>0?[{label:`Take the load off (${Xe(c)} kg)`,command:"load",press:()=>s.tell({type:"load",node:o,mass:0})}]:[],{label:"Kick it up (5 m/s)",command:"kick",press:()=>s.tell({type:"kick",node:o,velocity:ci(l,5)})}].filter(f=>s.can(f.command)),d=r.followed.has(o);No(this.host,e,i,[...u,{label:d?"Stop following":"Follow: trail and graphs",press:()=>this.follow(o)}],t.kind==="anchor"?`Anchor ${t.anchor}`:this.nodeName(t))}nodeName(t){let e=this.stage.session.layout?.variants[t.variant].ropes??[],i=e.find(({first:s,nodes:r})=>t.node>=s&&t.node<s+r);return i?`Node ${t.node-i.zero}${e.length>1?` of ${i.name}`:""}`:`Node ${t.node}`}};var ty=["r4","hanging-rope"],ey=2,xm="bdf2",Wo=[{title:"Hang it",text:"A rope is a chain of masses and springs. Let it hang and swing: its colour is the tension in newtons.",act:"Hang the rope",press:n=>n.hang(),done:({session:n,hung:t})=>t&&(n.frame?.time??0)>1},{title:"Move it",text:"Take an anchor, one of the squares, and move it. The arrow keys do it too, at 3 m/s. Then pull at the rope itself.",act:"",press:()=>{},done:({moved:n})=>n},{title:"Stiffen it until it breaks",text:"Make the springs stiffer and watch the meter: beyond the red line every step overshoots, nodes jump to and fro, and the rope breaks.",act:"Twice as stiff",press:n=>n.stiffen(),done:({session:n})=>n.broken!==null},{title:"Make the step smaller",text:"Nothing is wrong with the rope: the time step is too long for springs so stiff. A shorter step mends it, and costs more computing.",act:"Use a shorter step",press:n=>n.shorten(),done:({session:n})=>n.broken===null&&n.stability[0]?.stable===!0},{title:"Take an implicit method",text:"An implicit method solves for the next state and bears any stiffness with long steps. The meter has no red any more.",act:"Use an implicit method",press:n=>n.implicit(),done:({session:n})=>n.stability[0]?.bound===null}],gl=class{constructor(t,e){this.session=t,this.at=-1,this.hung=this.moved=!1,this.card=X("section",{className:"card tour",hidden:!0,"aria-label":"Guided tour",id:"tour"}),e.append(this.card),t.on("status",()=>this.check()),t.on("stability",()=>this.check()),t.on("broken",()=>this.check())}start(){if(this.at>=0){this.end();return}this.hung=this.moved=!1,this.go(0)}end(){this.at=-1,this.card.hidden=!0}handMoved(){this.moved||(this.moved=!0,this.check())}go(t){if(this.at=t,t>=Wo.length){this.end();return}let{title:e,text:i,act:s,press:r}=Wo[t],o=t===Wo.length-1;t===1&&(this.moved=!1);let a=t!==4||this.implicitMethod()!==null,c=X("button",{type:"button",className:"plain close","aria-label":"End the tour",onclick:()=>this.end()},mn("close"));this.card.replaceChildren(X("header",{},X("small",{},`Step ${t+1} of ${Wo.length}`),c),X("h2",{},e),X("p",{},i),a?"":X("p",{className:"faint"},"This version has no implicit method yet; a Runge-Kutta method bears a longer step."),X("div",{className:"row"},s!==""?X("button",{type:"button",className:"main",id:"tour-act",disabled:!a,onclick:()=>r(this)},s):"",X("span",{className:"gap"}),t>0?X("button",{type:"button",className:"second",onclick:()=>this.go(t-1)},"Back"):"",X("button",{type:"button",className:"second",id:"tour-next",onclick:()=>this.go(t+1)},o?"Finish":"Next"))),this.card.hidden=!1,this.check()}check(){if(this.at<0)return;let t=Wo[this.at].done(this);this.card.classList.toggle("done",t);let e=this.card.querySelector("#tour-next");e&&(e.className=t?"main":"second")}async hang(){let{session:t}=this,e=ty.find(i=>t.presets.some(s=>s.name===i))??t.presets[0]?.name;e&&t.can("scene")&&await t.tell({type:"scene",preset:e}),this.hung=!0,await t.tell({type:"play"})}async stiffen(){let{session:t}=this,e=t.parameters.find(i=>i.name==="spring_constant")??t.parameters.find(i=>i.name==="EA");!e||typeof e.value!="number"||(await t.tell({type:"set",name:e.name,value:e.value*ey}),t.status?.playing||await t.tell({type:"play"}))}async shorten(){let{session:t}=this;t.broken?await t.tell({type:"remedy",remedy:"step"}):await t.tell({type:"set",name:"time_step",value:"auto"}),await t.tell({type:"play"})}implicitMethod(){let e=this.session.parameters.find(s=>s.name==="method")?.choices??[];if(e.some(({value:s})=>s===xm))return xm;let i=e.find(({value:s,label:r})=>/implicit|sdirk|bdf|midpoint/i.test(`${s} ${r}`)&&!/semi-implicit/i.test(`${s}`));return i?i.value:null}async implicit(){let t=this.implicitMethod();t!==null&&(this.session.broken?await this.session.tell({type:"remedy",remedy:"implicit"}):await this.session.tell({type:"set",name:"method",value:t}),await this.session.tell({type:"play"}))}};var qn=class n{constructor(t,e,i,s,r="div"){this.parent=t,this.object=e,this.property=i,this._disabled=!1,this._hidden=!1,this.initialValue=this.getValue(),this.domElement=document.createElement(r),this.domElement.classList.add("lil-controller"),this.domElement.classList.add(s),this.$name=document.createElement("div"),this.$name.classList.add("lil-name"),n.nextNameID=n.nextNameID||0,this.$name.id=`lil-gui-name-${++n.nextNameID}`,this.$widget=document.createElement("div"),this.$widget.classList.add("lil-widget"),this.$disable=this.$widget,this.domElement.appendChild(this.$name),this.domElement.appendChild(this.$widget),this.domElement.addEventListener("keydown",o=>o.stopPropagation()),this.domElement.addEventListener("keyup",o=>o.stopPropagation()),this.parent.children.push(this),this.parent.controllers.push(this),this.parent.$children.appendChild(this.domElement),this._listenCallback=this._listenCallback.bind(this),this.name(i)}name(t){return this._name=t,this.$name.textContent=t,this}onChange(t){return this._onChange=t,this}_callOnChange(){this.parent._callOnChange(this),this._onChange!==void 0&&this._onChange.call(this,this.getValue()),this._changed=!0}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(){this._changed&&(this.parent._callOnFinishChange(this),this._onFinishChange!==void 0&&this._onFinishChange.call(this,this.getValue())),this._changed=!1}reset(){return this.setValue(this.initialValue),this._callOnFinishChange(),this}enable(t=!0){return this.disable(!t)}disable(t=!0){return t===this._disabled?this:(this._disabled=t,this.domElement.classList.toggle("lil-disabled",t),this.$disable.toggleAttribute("disabled",t),this)}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}options(t){let e=this.parent.add(this.object,this.property,t);return e.name(this._name),this.destroy(),e}min(t){return this}max(t){return this}step(t){return this}decimals(t){return this}listen(t=!0){return this._listening=t,this._listenCallbackID!==void 0&&(cancelAnimationFrame(this._listenCallbackID),this._listenCallbackID=void 0),this._listening&&this._listenCallback(),this}_listenCallback(){this._listenCallbackID=requestAnimationFrame(this._listenCallback);let t=this.save();t!==this._listenPrevValue&&this.updateDisplay(),this._listenPrevValue=t}getValue(){return this.object[this.property]}setValue(t){return this.getValue()!==t&&(this.object[this.property]=t,this._callOnChange(),this.updateDisplay()),this}updateDisplay(){return this}load(t){return this.setValue(t),this._callOnFinishChange(),this}save(){return this.getValue()}destroy(){this.listen(!1),this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.controllers.splice(this.parent.controllers.indexOf(this),1),this.parent.$children.removeChild(this.domElement)}},Cu=class extends qn{constructor(t,e,i){super(t,e,i,"lil-boolean","label"),this.$input=document.createElement("input"),this.$input.setAttribute("type","checkbox"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$widget.appendChild(this.$input),this.$input.addEventListener("change",()=>{this.setValue(this.$input.checked),this._callOnFinishChange()}),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.checked=this.getValue(),this}};function Pu(n){let t,e;return(t=n.match(/(#|0x)?([a-f0-9]{6})/i))?e=t[2]:(t=n.match(/rgb\(\s*(\d*)\s*,\s*(\d*)\s*,\s*(\d*)\s*\)/))?e=parseInt(t[1]).toString(16).padStart(2,0)+parseInt(t[2]).toString(16).padStart(2,0)+parseInt(t[3]).toString(16).padStart(2,0):(t=n.match(/^#?([a-f0-9])([a-f0-9])([a-f0-9])$/i))&&(e=t[1]+t[1]+t[2]+t[2]+t[3]+t[3]),e?"#"+e:!1}var iy={isPrimitive:!0,match:n=>typeof n=="string",fromHexString:Pu,toHexString:Pu},$o={isPrimitive:!0,match:n=>typeof n=="number",fromHexString:n=>parseInt(n.substring(1),16),toHexString:n=>"#"+n.toString(16).padStart(6,0)},ny={isPrimitive:!1,match:n=>Array.isArray(n)||ArrayBuffer.isView(n),fromHexString(n,t,e=1){let i=$o.fromHexString(n);t[0]=(i>>16&255)/255*e,t[1]=(i>>8&255)/255*e,t[2]=(i&255)/255*e},toHexString([n,t,e],i=1){i=255/i;let s=n*i<<16^t*i<<8^e*i<<0;return $o.toHexString(s)}},sy={isPrimitive:!1,match:n=>Object(n)===n,fromHexString(n,t,e=1){let i=$o.fromHexString(n);t.r=(i>>16&255)/255*e,t.g=(i>>8&255)/255*e,t.b=(i&255)/255*e},toHexString({r:n,g:t,b:e},i=1){i=255/i;let s=n*i<<16^t*i<<8^e*i<<0;return $o.toHexString(s)}},ry=[iy,$o,ny,sy];function oy(n){return ry.find(t=>t.match(n))}var Iu=class extends qn{constructor(t,e,i,s){super(t,e,i,"lil-color"),this.$input=document.createElement("input"),this.$input.setAttribute("type","color"),this.$input.setAttribute("tabindex",-1),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$text=document.createElement("input"),this.$text.setAttribute("type","text"),this.$text.setAttribute("spellcheck","false"),this.$text.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$display.appendChild(this.$input),this.$widget.appendChild(this.$display),this.$widget.appendChild(this.$text),this._format=oy(this.initialValue),this._rgbScale=s,this._initialValueHexString=this.save(),this._textFocused=!1,this.$input.addEventListener("input",()=>{this._setValueFromHexString(this.$input.value)}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$text.addEventListener("input",()=>{let r=Pu(this.$text.value);r&&this._setValueFromHexString(r)}),this.$text.addEventListener("focus",()=>{this._textFocused=!0,this.$text.select()}),this.$text.addEventListener("blur",()=>{this._textFocused=!1,this.updateDisplay(),this._callOnFinishChange()}),this.$disable=this.$text,this.updateDisplay()}reset(){return this._setValueFromHexString(this._initialValueHexString),this}_setValueFromHexString(t){if(this._format.isPrimitive){let e=this._format.fromHexString(t);this.setValue(e)}else this._format.fromHexString(t,this.getValue(),this._rgbScale),this._callOnChange(),this.updateDisplay()}save(){return this._format.toHexString(this.getValue(),this._rgbScale)}load(t){return this._setValueFromHexString(t),this._callOnFinishChange(),this}updateDisplay(){return this.$input.value=this._format.toHexString(this.getValue(),this._rgbScale),this._textFocused||(this.$text.value=this.$input.value.substring(1)),this.$display.style.backgroundColor=this.$input.value,this}},Xo=class extends qn{constructor(t,e,i){super(t,e,i,"lil-function"),this.$button=document.createElement("button"),this.$button.appendChild(this.$name),this.$widget.appendChild(this.$button),this.$button.addEventListener("click",s=>{s.preventDefault(),this.getValue().call(this.object),this._callOnChange()}),this.$button.addEventListener("touchstart",()=>{},{passive:!0}),this.$disable=this.$button}},Lu=class extends qn{constructor(t,e,i,s,r,o){super(t,e,i,"lil-number"),this._initInput(),this.min(s),this.max(r);let a=o!==void 0;this.step(a?o:this._getImplicitStep(),a),this.updateDisplay()}decimals(t){return this._decimals=t,this.updateDisplay(),this}min(t){return this._min=t,this._onUpdateMinMax(),this}max(t){return this._max=t,this._onUpdateMinMax(),this}step(t,e=!0){return this._step=t,this._stepExplicit=e,this}updateDisplay(){let t=this.getValue();if(this._hasSlider){let e=(t-this._min)/(this._max-this._min);e=Math.max(0,Math.min(e,1)),this.$fill.style.width=e*100+"%"}return this._inputFocused||(this.$input.value=this._decimals===void 0?t:t.toFixed(this._decimals)),this}_initInput(){this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("aria-labelledby",this.$name.id),window.matchMedia("(pointer: coarse)").matches&&(this.$input.setAttribute("type","number"),this.$input.setAttribute("step","any")),this.$widget.appendChild(this.$input),this.$disable=this.$input;let e=()=>{let v=parseFloat(this.$input.value);isNaN(v)||(this._stepExplicit&&(v=this._snap(v)),this.setValue(this._clamp(v)))},i=v=>{let A=parseFloat(this.$input.value);isNaN(A)||(this._snapClampSetValue(A+v),this.$input.value=this.getValue())},s=v=>{v.key==="Enter"&&this.$input.blur(),v.code==="ArrowUp"&&(v.preventDefault(),i(this._step*this._arrowKeyMultiplier(v))),v.code==="ArrowDown"&&(v.preventDefault(),i(this._step*this._arrowKeyMultiplier(v)*-1))},r=v=>{this._inputFocused&&(v.preventDefault(),i(this._step*this._normalizeMouseWheel(v)))},o=!1,a,c,l,h,u,d=5,f=v=>{a=v.clientX,c=l=v.clientY,o=!0,h=this.getValue(),u=0,window.addEventListener("mousemove",g),window.addEventListener("mouseup",y)},g=v=>{if(o){let A=v.clientX-a,S=v.clientY-c;Math.abs(S)>d?(v.preventDefault(),this.$input.blur(),o=!1,this._setDraggingStyle(!0,"vertical")):Math.abs(A)>d&&y()}if(!o){let A=v.clientY-l;u-=A*this._step*this._arrowKeyMultiplier(v),h+u>this._max?u=this._max-h:h+u<this._min&&(u=this._min-h),this._snapClampSetValue(h+u)}l=v.clientY},y=()=>{this._setDraggingStyle(!1,"vertical"),this._callOnFinishChange(),window.removeEventListener("mousemove",g),window.removeEventListener("mouseup",y)},m=()=>{this._inputFocused=!0},p=()=>{this._inputFocused=!1,this.updateDisplay(),this._callOnFinishChange()};this.$input.addEventListener("input",e),this.$input.addEventListener("keydown",s),this.$input.addEventListener("wheel",r,{passive:!1}),this.$input.addEventListener("mousedown",f),this.$input.addEventListener("focus",m),this.$input.addEventListener("blur",p)}_initSlider(){this._hasSlider=!0,this.$slider=document.createElement("div"),this.$slider.classList.add("lil-slider"),this.$fill=document.createElement("div"),this.$fill.classList.add("lil-fill"),this.$slider.appendChild(this.$fill),this.$widget.insertBefore(this.$slider,this.$input),this.domElement.classList.add("lil-has-slider");let t=(p,v,A,S,C)=>(p-v)/(A-v)*(C-S)+S,e=p=>{let v=this.$slider.getBoundingClientRect(),A=t(p,v.left,v.right,this._min,this._max);this._snapClampSetValue(A)},i=p=>{this._setDraggingStyle(!0),e(p.clientX),window.addEventListener("mousemove",s),window.addEventListener("mouseup",r)},s=p=>{e(p.clientX)},r=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("mousemove",s),window.removeEventListener("mouseup",r)},o=!1,a,c,l=p=>{p.preventDefault(),this._setDraggingStyle(!0),e(p.touches[0].clientX),o=!1},h=p=>{p.touches.length>1||(this._hasScrollBar?(a=p.touches[0].clientX,c=p.touches[0].clientY,o=!0):l(p),window.addEventListener("touchmove",u,{passive:!1}),window.addEventListener("touchend",d))},u=p=>{if(o){let v=p.touches[0].clientX-a,A=p.touches[0].clientY-c;Math.abs(v)>Math.abs(A)?l(p):(window.removeEventListener("touchmove",u),window.removeEventListener("touchend",d))}else p.preventDefault(),e(p.touches[0].clientX)},d=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("touchmove",u),window.removeEventListener("touchend",d)},f=this._callOnFinishChange.bind(this),g=400,y,m=p=>{if(Math.abs(p.deltaX)<Math.abs(p.deltaY)&&this._hasScrollBar)return;p.preventDefault();let A=this._normalizeMouseWheel(p)*this._step;this._snapClampSetValue(this.getValue()+A),this.$input.value=this.getValue(),clearTimeout(y),y=setTimeout(f,g)};this.$slider.addEventListener("mousedown",i),this.$slider.addEventListener("touchstart",h,{passive:!1}),this.$slider.addEventListener("wheel",m,{passive:!1})}_setDraggingStyle(t,e="horizontal"){this.$slider&&this.$slider.classList.toggle("lil-active",t),document.body.classList.toggle("lil-dragging",t),document.body.classList.toggle(`lil-${e}`,t)}_getImplicitStep(){return this._hasMin&&this._hasMax?(this._max-this._min)/1e3:.1}_onUpdateMinMax(){!this._hasSlider&&this._hasMin&&this._hasMax&&(this._stepExplicit||this.step(this._getImplicitStep(),!1),this._initSlider(),this.updateDisplay())}_normalizeMouseWheel(t){let{deltaX:e,deltaY:i}=t;return Math.floor(t.deltaY)!==t.deltaY&&t.wheelDelta&&(e=0,i=-t.wheelDelta/120,i*=this._stepExplicit?1:10),e+-i}_arrowKeyMultiplier(t){let e=this._stepExplicit?1:10;return t.shiftKey?e*=10:t.altKey&&(e/=10),e}_snap(t){let e=0;return this._hasMin?e=this._min:this._hasMax&&(e=this._max),t-=e,t=Math.round(t/this._step)*this._step,t+=e,t=parseFloat(t.toPrecision(15)),t}_clamp(t){return t<this._min&&(t=this._min),t>this._max&&(t=this._max),t}_snapClampSetValue(t){this.setValue(this._clamp(this._snap(t)))}get _hasScrollBar(){let t=this.parent.root.$children;return t.scrollHeight>t.clientHeight}get _hasMin(){return this._min!==void 0}get _hasMax(){return this._max!==void 0}},Nu=class extends qn{constructor(t,e,i,s){super(t,e,i,"lil-option"),this.$select=document.createElement("select"),this.$select.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$select.addEventListener("change",()=>{this.setValue(this._values[this.$select.selectedIndex]),this._callOnFinishChange()}),this.$select.addEventListener("focus",()=>{this.$display.classList.add("lil-focus")}),this.$select.addEventListener("blur",()=>{this.$display.classList.remove("lil-focus")}),this.$widget.appendChild(this.$select),this.$widget.appendChild(this.$display),this.$disable=this.$select,this.options(s)}options(t){return this._values=Array.isArray(t)?t:Object.values(t),this._names=Array.isArray(t)?t:Object.keys(t),this.$select.replaceChildren(),this._names.forEach(e=>{let i=document.createElement("option");i.textContent=e,this.$select.appendChild(i)}),this.updateDisplay(),this}updateDisplay(){let t=this.getValue(),e=this._values.indexOf(t);return this.$select.selectedIndex=e,this.$display.textContent=e===-1?t:this._names[e],this}},Du=class extends qn{constructor(t,e,i){super(t,e,i,"lil-string"),this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("spellcheck","false"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$input.addEventListener("input",()=>{this.setValue(this.$input.value)}),this.$input.addEventListener("keydown",s=>{s.code==="Enter"&&this.$input.blur()}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$widget.appendChild(this.$input),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.value=this.getValue(),this}},ay=`.lil-gui {
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
}`;function ly(n){let t=document.createElement("style");t.innerHTML=n;let e=document.querySelector("head link[rel=stylesheet], head style");e?document.head.insertBefore(t,e):document.head.appendChild(t)}var vm=!1,_l=class n{constructor({parent:t,autoPlace:e=t===void 0,container:i,width:s,title:r="Controls",closeFolders:o=!1,injectStyles:a=!0,touchStyles:c=!0}={}){if(this.parent=t,this.root=t?t.root:this,this.children=[],this.controllers=[],this.folders=[],this._closed=!1,this._hidden=!1,this.domElement=document.createElement("div"),this.domElement.classList.add("lil-gui"),this.$title=document.createElement("button"),this.$title.classList.add("lil-title"),this.$title.setAttribute("aria-expanded",!0),this.$title.addEventListener("click",()=>this.openAnimated(this._closed)),this.$title.addEventListener("touchstart",()=>{},{passive:!0}),this.$children=document.createElement("div"),this.$children.classList.add("lil-children"),this.domElement.appendChild(this.$title),this.domElement.appendChild(this.$children),this.title(r),this.parent){this.parent.children.push(this),this.parent.folders.push(this),this.parent.$children.appendChild(this.domElement);return}this.domElement.classList.add("lil-root"),c&&this.domElement.classList.add("lil-allow-touch-styles"),!vm&&a&&(ly(ay),vm=!0),i?i.appendChild(this.domElement):e&&(this.domElement.classList.add("lil-auto-place","autoPlace"),document.body.appendChild(this.domElement)),s&&this.domElement.style.setProperty("--width",s+"px"),this._closeFolders=o}add(t,e,i,s,r){if(Object(i)===i)return new Nu(this,t,e,i);let o=t[e];switch(typeof o){case"number":return new Lu(this,t,e,i,s,r);case"boolean":return new Cu(this,t,e);case"string":return new Du(this,t,e);case"function":return new Xo(this,t,e)}console.error(`gui.add failed
	property:`,e,`
	object:`,t,`
	value:`,o)}addColor(t,e,i=1){return new Iu(this,t,e,i)}addFolder(t){let e=new n({parent:this,title:t});return this.root._closeFolders&&e.close(),e}load(t,e=!0){return t.controllers&&this.controllers.forEach(i=>{i instanceof Xo||i._name in t.controllers&&i.load(t.controllers[i._name])}),e&&t.folders&&this.folders.forEach(i=>{i._title in t.folders&&i.load(t.folders[i._title])}),this}save(t=!0){let e={controllers:{},folders:{}};return this.controllers.forEach(i=>{if(!(i instanceof Xo)){if(i._name in e.controllers)throw new Error(`Cannot save GUI with duplicate property "${i._name}"`);e.controllers[i._name]=i.save()}}),t&&this.folders.forEach(i=>{if(i._title in e.folders)throw new Error(`Cannot save GUI with duplicate folder "${i._title}"`);e.folders[i._title]=i.save()}),e}open(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),this.domElement.classList.toggle("lil-closed",this._closed),this}close(){return this.open(!1)}_setClosed(t){this._closed!==t&&(this._closed=t,this._callOnOpenClose(this))}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}openAnimated(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),requestAnimationFrame(()=>{let e=this.$children.clientHeight;this.$children.style.height=e+"px",this.domElement.classList.add("lil-transition");let i=r=>{r.target===this.$children&&(this.$children.style.height="",this.domElement.classList.remove("lil-transition"),this.$children.removeEventListener("transitionend",i))};this.$children.addEventListener("transitionend",i);let s=t?this.$children.scrollHeight:0;this.domElement.classList.toggle("lil-closed",!t),requestAnimationFrame(()=>{this.$children.style.height=s+"px"})}),this}title(t){return this._title=t,this.$title.textContent=t,this}reset(t=!0){return(t?this.controllersRecursive():this.controllers).forEach(i=>i.reset()),this}onChange(t){return this._onChange=t,this}_callOnChange(t){this.parent&&this.parent._callOnChange(t),this._onChange!==void 0&&this._onChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(t){this.parent&&this.parent._callOnFinishChange(t),this._onFinishChange!==void 0&&this._onFinishChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onOpenClose(t){return this._onOpenClose=t,this}_callOnOpenClose(t){this.parent&&this.parent._callOnOpenClose(t),this._onOpenClose!==void 0&&this._onOpenClose.call(this,t)}destroy(){this.parent&&(this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.folders.splice(this.parent.folders.indexOf(this),1)),this.domElement.parentElement&&this.domElement.parentElement.removeChild(this.domElement),Array.from(this.children).forEach(t=>t.destroy())}controllersRecursive(){let t=Array.from(this.controllers);return this.folders.forEach(e=>{t=t.concat(e.controllersRecursive())}),t}foldersRecursive(){let t=Array.from(this.folders);return this.folders.forEach(e=>{t=t.concat(e.foldersRecursive())}),t}};var Fu=1e3,cy=9,ym=qn,xl=class extends ym{constructor(t,e,i){super(t,e,"value","quantity"),this.parameter=i,this.sliding=!1,this.slider=X("input",{type:"range",min:"0",max:String(Fu),step:"1","aria-label":i.label,oninput:()=>{this.sliding=!0,this.setValue(fm(this.scale,Number(this.slider.value)/Fu))},onchange:()=>{this.sliding=!1,this._callOnFinishChange()}}),this.field=X("input",{type:"text",inputMode:"decimal",spellcheck:!1,autocomplete:"off","aria-label":`${i.label} [${i.unit}]`,onchange:()=>this.commit(),onkeydown:s=>{s.key==="Enter"&&this.commit()}}),this.$widget.append(this.slider,this.field),this.updateDisplay()}get scale(){let{low:t,high:e,scale:i,kind:s}=this.parameter;return{low:t,high:e,scale:i,whole:s==="whole"}}commit(){let t=this.getValue(),i=t!==null&&this.field.value===$r(t)?t:tr(this.field.value);Number.isFinite(i)&&i!==t?this.setValue(i):this.updateDisplay()}updateDisplay(){let t=this.getValue();this.sliding||(this.slider.value=String(t===null?0:Fu*pm(this.scale,t)));let e=t===null?"":$r(t);(document.activeElement!==this.field||this.sliding)&&(this.field.value=e,this.field.placeholder=t===null?"differ":"");let i=t===null?"":String(t);return this.field.toggleAttribute("title",e!==i),e!==i&&(this.field.title=i),this}disable(t=!0){return this.slider.disabled=this.field.disabled=t,super.disable(t)}},vl=class extends ym{constructor(t,e,i){super(t,e,"value","vector"),this.fields=["x","y","z"].map(s=>X("input",{type:"text",inputMode:"decimal",spellcheck:!1,autocomplete:"off","aria-label":`${i.label} ${s} [${i.unit}]`,onchange:()=>this.commit()})),this.$widget.append(...this.fields),this.updateDisplay()}commit(){let t=this.getValue()??[],e=this.fields.map(({value:i},s)=>i===this.text(t[s])?t[s]:tr(i));e.every(Number.isFinite)?this.setValue(e):this.updateDisplay()}updateDisplay(){let t=this.getValue()??["","",""];return this.fields.forEach((e,i)=>{document.activeElement!==e&&(e.value=this.text(t[i]),e.title=`${"xyz"[i]}: ${t[i]}`)}),this}text(t){return typeof t=="number"?$r(t,cy):""}disable(t=!0){for(let e of this.fields)e.disabled=t;return super.disable(t)}};var yl=class{constructor(t,e){this.session=t,this.host=e,this.gui=null,this.rows=new Map,this.queue=new Map,this.asked=new Set,this.rope="",this.built="",this.closed=new Map,t.on("parameters",i=>this.build(i))}build(t){let e=JSON.stringify(t.map(i=>[i.name,i.kind,i.unit,i.choices,i.group,i.more,i.label,Object.keys(i.values??{})]));e===this.built&&this.gui?this.refresh(t):this.rebuild(t,e)}rebuild(t,e){let i=this.host.scrollTop;this.built=e,this.gui?.destroy(),this.rows.clear(),this.gui=new _l({container:this.host,injectStyles:!1,title:"Change it while it runs"});let s=[...new Set(t.flatMap(o=>Object.keys(o.values??{})))];s.includes(this.rope)||(this.rope=""),s.length>1&&this.addRopeChoice(this.gui,s);for(let o of t)o.more||this.addRow(this.gui,o);let r=t.filter(({more:o})=>o);if(r.length){let o=this.addFolder(this.gui,"More",!0);for(let a of[...new Set(r.map(c=>c.group))]){let c=this.addFolder(o,a,a==="Air"||a==="Ground");for(let l of r)l.group===a&&this.addRow(c,l)}}this.host.scrollTop=i}addFolder(t,e,i){let s=t.addFolder(e);return s.onOpenClose(r=>{r===s&&this.closed.set(e,s._closed)}),(this.closed.get(e)??i)&&s.close(),s}addRopeChoice(t,e){let i=Object.fromEntries([["all ropes",""],...e.map(s=>[s,s])]);t.add(this,"rope",i).name("Change").onChange(()=>this.refresh(this.session.parameters))}addRow(t,e){let i={value:this.valueOf(e)},s;if(e.kind==="choice"){let l=(e.choices??[]).map(({value:h,label:u})=>[u,h]);s=t.add(i,"value",Object.fromEntries(l))}else e.kind==="flag"?s=t.add(i,"value"):e.kind==="vector"?s=new vl(t,i,e):s=new xl(t,i,e);let r=Pr(e.unit),o=X("button",{type:"button",className:"back",onclick:()=>this.set(e.name,null)},mn("undo")),a=X("div",{className:"fault",hidden:!0,role:"alert"});s.name(""),s.$name.append(X("span",{},e.label),r&&X("em",{},r),o),s.domElement.append(a),s.domElement.dataset.parameter=e.name,s.onChange(l=>this.set(e.name,l));let c={parameter:e,holder:i,controller:s,back:o,fault:a};this.rows.set(e.name,c),this.show(c)}valueOf(t){return this.rope&&t.values&&this.rope in t.values?t.values[this.rope]:t.value}show(t){let{parameter:e,controller:i,holder:s,back:r}=t;t.controller.parameter=e,s.value=this.valueOf(e),i.updateDisplay(),i.disable(!e.enabled);let o=Uu(e.default),a=Uu(s.value)!==o;r.classList.toggle("unused",!a),r.disabled=!a||!e.enabled,r.title=`Back to ${o||"the scene's"} ${Pr(e.unit)}`.trim(),r.setAttribute("aria-label",`${e.label}: back to the scene's value`),i.domElement.title=e.enabled?e.help:e.why||e.help}refresh(t){for(let e of t){let i=this.rows.get(e.name);i&&(i.parameter=e,this.busy(e.name)||this.show(i))}}busy(t){return this.queue.has(t)||this.asked.has(t)||this.rows.get(t)?.controller.sliding}set(t,e){this.queue.size||requestAnimationFrame(()=>this.flush()),this.queue.set(t,e)}flush(){for(let[t,e]of this.queue)this.asked.has(t)||(this.queue.delete(t),this.send(t,e))}async send(t,e){let i=this.rows.get(t);this.asked.add(t);try{let o=this.rope&&i?.parameter.values?this.rope:null;await this.session.ask({type:"set",name:t,value:e,rope:o}),this.fault(t,"")}catch(o){this.fault(t,o.text)}if(this.asked.delete(t),this.queue.has(t)){this.flush();return}let s=this.rows.get(t),r=this.session.parameters.find(o=>o.name===t);s&&r&&!s.controller.sliding&&(s.parameter=r,this.show(s))}fault(t,e){let i=this.rows.get(t);i&&(i.fault.hidden=e==="",i.fault.textContent=e)}};function Uu(n){return n==null?"":typeof n=="number"?String(Number(n.toPrecision(6))):Array.isArray(n)?`[${n.map(Uu).join(", ")}]`:String(n)}var Ml=class{constructor(t,e){this.stage=t;let i=(s,r)=>X("button",{type:"button",className:"plain letter",id:`view-${s.toLowerCase()}`,title:`Look along the ${s.toLowerCase()} axis; again: from the other side`,"aria-label":`Look along the ${s.toLowerCase()} axis`,onclick:()=>this.along(r)},s);e.append(X("div",{className:"toolbar views",role:"toolbar","aria-label":"View"},Ni("fit","Show everything",()=>t.fit(),{key:"F",id:"view-fit"}),i("X",0),i("Y",1),i("Z",2),X("button",{type:"button",className:"plain letter",id:"view-home",title:"The first view","aria-label":"The first view",onclick:()=>this.home()},"3D")))}along(t){let{camera:e}=this.stage,i=t===1&&Math.abs(e.up[1])<.9?-1:1,s=e.along(t,i),r=Math.abs(e.toward[t]-i)<.001;this.stage.fit(r?e.along(t,i===1?-1:1):s)}home(){let{layout:t}=this.stage.session;t&&this.stage.fly(this.stage.firstPose(t))}};var er=class{constructor(t){this.shown=new Float32Array(t),this.from=new Float32Array(t),this.to=new Float32Array(t),this.arrival=0,this.spacing=1e3/60,this.part=1,this.empty=!0}next(t,e=!1){let i=t-this.arrival;return this.arrival=t,this.empty||e?(this.empty=!1,this.part=1-1e-9,this.arrival=-1/0,this.to):(i<250&&(this.spacing+=.15*(Math.max(4,i)-this.spacing)),this.from.set(this.shown),this.part=0,this.to)}advance(t){if(this.empty||this.part>=1)return!1;this.part=Math.min(1,Math.max(this.part,(t-this.arrival)/this.spacing));let{shown:e,from:i,to:s,part:r}=this;if(r>=1)e.set(s);else for(let o=0;o<e.length;o++)e[o]=i[o]+r*(s[o]-i[o]);return!0}};var Ou=34*Math.PI/180,hy=80,Sl=Math.PI/2,bl=class n{constructor(){this.width=1,this.height=1,this.pose={target:[0,0,0],distance:5,azimuth:-Sl+.5,elevation:.22},this.view=new Float32Array(16),this.projection=new Float32Array(16),this.version=0,this.up=[0,0,1],this.first=[1,0,0],this.second=[0,1,0],this.eye=[0,0,0],this.right=[1,0,0],this.top=[0,0,1],this.toward=[0,-1,0],this.update()}setUp(t){this.up=Gh(t);let e=Math.abs(this.up[0])<.9?[1,0,0]:[0,0,1];this.first=Gh(pn(e,ci(this.up,Pi(e,this.up)))),this.second=Po(this.up,this.first),this.update()}resize(t,e){this.width=Math.max(1,t),this.height=Math.max(1,e),this.update()}set(t){let e={...this.pose,...t},{target:i,distance:s,azimuth:r,elevation:o}=e;[...i,s,r,o].every(Number.isFinite)&&(this.pose=e,this.pose.elevation=Math.min(Sl,Math.max(-Sl,this.pose.elevation)),this.pose.distance=Math.min(1e7,Math.max(1e-4,this.pose.distance)),this.update())}update(){let{target:t,distance:e,azimuth:i,elevation:s}=this.pose,[r,o]=[Math.cos(i),Math.sin(i)],[a,c]=[Math.cos(s),Math.sin(s)],l=ve(ci(this.first,r),this.second,o);this.toward=ve(ci(l,a),this.up,c),this.right=ve(ci(this.first,-o),this.second,r),this.top=Po(this.toward,this.right),this.eye=ve(t,this.toward,e);let h=[this.right,this.top,this.toward];for(let g=0;g<3;g++){for(let y=0;y<3;y++)this.view[4*y+g]=h[g][y];this.view[12+g]=-Pi(h[g],this.eye),this.view[4*g+3]=0}this.view[15]=1;let u=e*.01,d=e*200,f=1/Math.tan(Ou/2);this.projection.fill(0),this.projection[0]=f*this.height/this.width,this.projection[5]=f,this.projection[10]=(d+u)/(u-d),this.projection[11]=-1,this.projection[14]=2*d*u/(u-d),this.version++}get focal(){return this.height/2/Math.tan(Ou/2)}project(t,e,i){let s=this.view,r=-(s[2]*t+s[6]*e+s[10]*i+s[14]),o=this.focal/Math.max(r,1e-9);return[this.width/2+(s[0]*t+s[4]*e+s[8]*i+s[12])*o,this.height/2-(s[1]*t+s[5]*e+s[9]*i+s[13])*o,r]}ray(t,e){let i=(t-this.width/2)/this.focal,s=(this.height/2-e)/this.focal;return ve(ve(ci(this.toward,-1),this.right,i),this.top,s)}inPlane(t,e,i){let s=Pi(pn(this.eye,i),this.toward);return ve(this.eye,this.ray(t,e),s)}orbit(t,e){let i=1.2*Math.PI/Math.min(this.width,this.height);this.set({azimuth:this.pose.azimuth-t*i,elevation:this.pose.elevation+e*i})}pan(t,e){let i=this.pose.distance/this.focal,s=ve(ve(this.pose.target,this.right,-t*i),this.top,e*i);this.set({target:s})}zoom(t,e=this.width/2,i=this.height/2){let s=this.inPlane(e,i,this.pose.target);this.set({distance:this.pose.distance*t});let r=this.inPlane(e,i,this.pose.target);this.set({target:ve(this.pose.target,pn(s,r))})}at(t){let e=new n;return e.setUp(this.up),e.resize(this.width,this.height),e.set({...this.pose,...t}),e}fitted(t,e={},{top:i,bottom:s}={top:0,bottom:0}){let r=ci(ve(t.low,t.high),.5),o=this.at({...e,target:r,distance:1}),a=Math.tan(Ou/2),c=Math.max(.3,1-(i+s)/this.height),l=a*.86*c,h=a*Math.max(.7*this.width,this.width-2*hy)/this.height,u=.001;for(let f=0;f<8;f++){let g=[0,1,2].map(p=>f>>p&1?t.high[p]:t.low[p]),y=pn(g,r),m=Pi(y,o.toward);u=Math.max(u,m+Math.abs(Pi(y,o.right))/h,m+Math.abs(Pi(y,o.top))/l)}let d=(i-s)/2*(u/this.focal);return{...o.pose,target:ve(r,o.top,d),distance:u}}along(t,e=1){let i=[0,0,0];return i[t]=e,this.angles(i)}angles(t){let e=Pi(t,this.up),i=Pi(t,this.first),s=Pi(t,this.second);return{azimuth:Math.hypot(i,s)>1e-6?Math.atan2(s,i):-Sl,elevation:Math.atan2(e,Math.hypot(i,s))}}};var uy=320,wl=class{constructor(t,e,i){let s=e.azimuth-t.azimuth;this.from=t,this.to=e,this.turn=s-2*Math.PI*Math.round(s/(2*Math.PI)),this.start=i}at(t){let e=Math.min(1,Math.max(0,(t-this.start)/uy)),i=e*e*(3-2*e),{from:s,to:r}=this;return{over:e>=1,pose:{target:ve(s.target,pn(r.target,s.target),i),distance:s.distance*(r.distance/s.distance)**i,azimuth:s.azimuth+i*this.turn,elevation:s.elevation+i*(r.elevation-s.elevation)}}}};var dy=1e4;function Mm(n,t,{center:e,radius:i}){let[s,r,o]=e,a=dy*i,c=h=>!(Math.abs(n[h]-s)<a&&Math.abs(n[h+1]-r)<a&&Math.abs(n[h+2]-o)<a),l=null;for(let h=0,u=0;h<t;h++,u+=4)if(c(u)){if(h>0)l=n.subarray(u-4,u-1);else{let d=0;for(;d<t&&c(4*d);)d++;l=d<t?n.slice(4*d,4*d+3):e}n.set(l,u),Number.isFinite(n[u+3])||(n[u+3]=0)}}function El(n,t){let e={low:[1/0,1/0,1/0],high:[-1/0,-1/0,-1/0]};for(let i=0;i<t;i++)for(let s=0;s<3;s++){let r=n[4*i+s];r<e.low[s]&&(e.low[s]=r),r>e.high[s]&&(e.high[s]=r)}return e}function fy(n,t,e){let i=[0,1,2].filter(r=>n.high[r]-n.low[r]<1e-4*e);if(!i.length)return-1;let s=i.filter(r=>Math.abs(t[r])<.9);return s.length>1?s.includes(1)?1:s[s.length-1]:s.length?s[0]:i[0]}function Sm(n,t,e){let{center:i,radius:s}=t.view,r=fy(e,n.up,s),o=r>=0&&Math.abs(n.up[r])>.9,a={azimuth:-Math.PI/2+.55,elevation:.3};if(o)a={azimuth:-Math.PI/2,elevation:Math.PI/2};else if(r>=0){let h=fn([0,0,0]);h[r]=1;let u=Pi(Po(n.up,h),[1,1,1])>=0?1:-1;a={...n.along(r,u),elevation:.07}}let c=ci([1,1,1],s);r>=0&&(c[r]=0);let l={low:pn(i,c),high:ve(i,c)};return n.fitted(py(l,e),a)}function py(n,t){return{low:fn([0,1,2].map(e=>Math.min(n.low[e],t.low[e]))),high:fn([0,1,2].map(e=>Math.max(n.high[e],t.high[e])))}}function bm(n,t,e){let i=t.ground?t.ground.height:e,s=If(Math.max(t.view.radius,n.pose.distance*.25)/5),{target:r}=n.pose,o=Math.round(Pi(r,n.first)/s)*s,a=Math.round(Pi(r,n.second)/s)*s,c=ve(ve(ci(n.first,o),n.second,a),n.up,i);return{height:i,solid:t.ground!==null,spacing:s,radius:14*s,center:c}}var my=["background","grid","shadow","ground","anchor","hand","load","arrow","grab","pin","hover","node"],wm="ropewalk-theme";function Em(){let n=new URLSearchParams(location.search).get("theme")??gy();return n==="light"||n==="dark"?n:matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"}function gy(){try{return localStorage.getItem(wm)}catch{return null}}function Tl(n,t=!1){if(document.documentElement.dataset.theme=n,!!t)try{localStorage.setItem(wm,n)}catch{}}function ku(){let n=getComputedStyle(document.documentElement);return{...Object.fromEntries(my.map(e=>[e,qs(n.getPropertyValue(`--scene-${e}`).trim()||"#888888")])),dark:document.documentElement.dataset.theme==="dark"}}function Al(n){let t=Math.max(1,Math.min(1024,n));return[t,Math.max(1,Math.ceil(n/t))]}function Tm(n,t,e,i,s){let r=0,[o,a]=[1/0,-1/0];return t.variants.forEach((c,l)=>{let h=n.parts[l],[u,d,f]=i[l],{positions:g}=h;for(let y=0,m=0,p=r;y<c.nodes;y++,m+=3,p+=4)s[p]=g[m]+u,s[p+1]=g[m+1]+d,s[p+2]=g[m+2]+f;if(e==="speed"){let y=gn(t,h,"speed_high");for(let m=0;m<c.nodes;m++)s[r+4*m+3]=h.speed[m]/65535*y;o=0,a=Math.max(a,y)}else if(e!=="plain"){let y=gn(t,h,"tension_low"),m=(gn(t,h,"tension_high")-y)/65535;for(let p of c.ropes){let v=e==="strain"?1/p.EA:1,A=p.first+p.nodes-1,S=h.tension[p.first];for(let C=p.first;C<=A;C++){let T=C<A?h.tension[C]:S,x=(y+m*.5*(S+T))*v;S=T,s[r+4*C+3]=x,x<o&&(o=x),x>a&&(a=x)}}}r+=4*c.nodes}),{low:o,high:a}}var Rl=class{constructor(t,e){this.nodes=t,this.colours=e,this.points=new Float32Array(4*360*t.length),this.head=0,this.version=0,this.empty=!0}push(t){let e=this.empty?360:1;for(let i=0;i<e;i++)this.nodes.forEach((s,r)=>{let o=4*(r*360+this.head);for(let a=0;a<3;a++)this.points[o+a]=t[4*s+a]}),this.head=(this.head+1)%360;this.empty=!1,this.version++}clear(){this.empty=!0,this.version++}};var _y=84,xy=8,Cl=class{constructor(t){this.stage=t,this.dirty=!0,this.reactions=!0,this.trails=null,this.followed=new Set,this.hover=null,this.kick=null,this.strongest=0,this.labels=[]}setLayout(t){let e=t.variants[0].nodes;for(let i of this.followed)i>=e&&this.followed.delete(i);this.resetTrails(),this.strongest=0,this.hover=this.kick=null}toggleTrail(t){this.followed.delete(t)||this.followed.add(t),this.followed.size>8&&this.followed.delete([...this.followed][0]),this.resetTrails()}resetTrails(){let t=[...this.followed],e=t.map((i,s)=>qs(Qe[(s+1)%Qe.length]));this.trails=t.length?new Rl(t,e):null,this.dirty=!0}collect(){let t=[],e=[];this.labels=[];let{session:i}=this.stage;return i.layout&&i.frame&&(this.addAnchors(t,e),this.addLoads(t),this.addGrabs(t,e),this.addHand(t,e)),{markers:t,arrows:e}}addAnchors(t,e){let{session:i,theme:s,anchors:r,camera:o}=this.stage,a=i.layout,c=i.frame,h=Math.min(_y,.14*o.width)*o.pose.distance/o.focal,u=0,d=0,f=[];if(a.variants.forEach((g,y)=>{let m=c.parts[y];g.anchors.forEach((p,v)=>{let A=fn(r.shown.subarray(u,u+3));if(u+=3,m.anchors[10*v+9]<.5||!A.every(Number.isFinite))return;let[S,C,T]=A,x=p.pinned?s.pin:p.motion==="hand"?s.hand:s.anchor,E=p.pinned?12:17;t.push({x:S,y:C,z:T,kind:"square",colour:x,size:0,pixels:E});let k=[...m.anchors.subarray(10*v+6,10*v+9)],N=Math.hypot(...k);Number.isFinite(N)&&(d=Math.max(d,N),(y===0||this.stage.apart)&&f.push({place:A,force:k,size:N}))})}),!!this.reactions){this.strongest=Math.max(d,this.strongest*.995);for(let{place:g,force:y,size:m}of f){if(m<.04*this.strongest||m<1e-9)continue;let p=ve(g,y,h/this.strongest);e.push({from:g,to:p,colour:s.arrow,pixels:2.6,head:!0}),f.length<=xy&&this.labels.push({from:g,at:p,text:gi(m,"N"),kind:"reaction"})}}}addLoads(t){let{session:e,theme:i,nodes:s,starts:r}=this.stage;e.layout.variants.forEach((a,c)=>{let l=a.ropes.reduce((h,u)=>h+u.mass,0);for(let h of a.loads){let u=4*(r[c]+h.index),[d,f,g]=s.shown.subarray(u,u+3),y=9+11*Math.min(1.6,Math.cbrt(h.mass/Math.max(l,1e-9)));t.push({x:d,y:f,z:g,kind:"round",colour:i.load,size:0,pixels:y})}});for(let[a,c]of[...this.followed].entries()){let[l,h,u]=s.shown.subarray(4*c,4*c+3),d=qs(Qe[(a+1)%Qe.length]);t.push({x:l,y:h,z:u,kind:"round",colour:d,size:0,pixels:8})}}addGrabs(t,e){let{session:i,theme:s,nodes:r,starts:o,shifts:a}=this.stage;i.frame.parts.forEach((l,h)=>{for(let u=0;u<l.grabs.length;u+=8){let d=l.grabs[u];if(!(d>=0))continue;let f=4*(o[h]+d),g=fn(r.shown.subarray(f,f+3)),y=ve(l.grabs.subarray(u+1,u+4),a[h]);e.push({from:g,to:y,colour:s.grab,pixels:2,head:!1}),t.push({x:y[0],y:y[1],z:y[2],kind:"ring",colour:s.grab,size:0,pixels:16});let[m,p,v]=l.grabs.subarray(u+4,u+7);h===0&&this.labels.push({from:g,at:y,text:gi(Math.hypot(m,p,v),"N"),kind:"grab"})}})}addHand(t,e){let{theme:i}=this.stage;if(this.hover){let[a,c,l]=this.hover;t.push({x:a,y:c,z:l,kind:"ring",colour:i.hover,size:0,pixels:24})}if(!this.kick)return;let{from:s,to:r,text:o}=this.kick;e.push({from:s,to:r,colour:i.grab,pixels:3,head:!0}),this.labels.push({from:s,at:r,text:o,kind:"kick"})}get scale(){return gi(this.strongest,"N")}};var vy=60,yy=1,Pl=class{constructor(t,e){this.session=t,this.renderer=e,this.camera=new bl,this.nodes=new er(4),this.anchors=new er(0),this.range=new Io,this.colouring="tension",this.dots=!1,this.apart=!1,this.shifts=[[0,0,0]],this.starts=[0],this.theme=ku(),this.marks=new Cl(this),this.dirty=!0,this.drawn=0,this.spacing=1,this.floor=0,this.flight=null,this.lookPending=!0,this.layoutNumber=-1,this.up=[0,0,1],this.sceneKey="",this.lastTime=-1/0,this.lastPush=0,this.cameraVersion=-1,this.card=()=>null,this.afterDraw=[],t.on("layout",s=>this.takeLayout(s)),t.on("frame",s=>this.takeFrame(s)),t.on("broken",()=>this.range.fresh=!0),e.setTheme(this.theme),e.canvas.addEventListener("webglcontextrestored",()=>this.setTheme());let i=s=>{requestAnimationFrame(i),this.tick(s)};requestAnimationFrame(i)}takeLayout(t){if(this.dirty=!0,t.layout===this.layoutNumber){this.follow(t);return}this.layoutNumber=t.layout,this.starts=Tu(t);let e=Cn(t),[i,s]=Al(e);this.nodes=new er(4*i*s),this.anchors=new er(3*t.variants.reduce((o,{anchors:a})=>o+a.length,0)),this.up=t.up,this.camera.setUp(t.up),this.renderer.setShape(um(t)),this.marks.setLayout(t);let r=`${t.scene.name} ${t.scene.preset} ${t.variants.length>1&&this.apart}`;r!==this.sceneKey&&(this.sceneKey=r,this.lookPending=!0,this.range.fresh=!0),this.shift(t)}follow({up:t,gravity:e}){t.every((s,r)=>Math.abs(s-this.up[r])<1e-6)||e.every(s=>s===0)||(this.up=t,this.camera.setUp(t),this.lookPending=!0)}shift(t){let e=this.lookPending?this.camera.first:this.camera.right;this.shifts=dm(t,this.apart,e,2.1*t.view.radius)}setApart(t){this.apart=t;let{layout:e,frame:i}=this.session;e&&(this.shift(e),this.lookPending=!0,i&&this.takeFrame(i,!0))}takeFrame(t,e=!1){let i=this.session.layout,s=performance.now(),r=e||t.time<this.lastTime||!(t.flags&1);t.time<this.lastTime&&this.marks.trails?.clear(),(t.time<this.lastTime||t.time>this.lastTime+yy)&&(this.range.fresh=!0,this.marks.strongest=0),this.lastTime=t.time;let o=this.nodes.next(s,r),a=Tm(t,i,this.colouring,this.shifts,o);Mm(o,Cn(i),i.view),t.flags&2||this.range.follow(a.low,a.high,Math.min(.2,(s-this.lastPush)/1e3)),this.lastPush=s,this.gatherAnchors(t,this.anchors.next(s,r)),this.lookPending&&this.look(i),this.marks.trails&&this.marks.trails.push(this.nodes.to),this.dirty=!0}showInstead(t,e=0){let{frame:i}=this.session;if(!i)return;if(!t)return this.takeFrame(i,!0);let s=Float32Array.from(t.flat()),r=i.parts.map((o,a)=>a===e&&s.length===o.positions.length?{...o,positions:s}:o);this.takeFrame({...i,parts:r,flags:i.flags|2},!0)}gatherAnchors(t,e){let i=0;t.parts.forEach((s,r)=>{for(let o=0;o<s.anchors.length;o+=10)for(let a=0;a<3;a++)e[i++]=s.anchors[o+a]+this.shifts[r][a]})}look(t){this.lookPending=!1;let e=Cn(t),i=El(this.nodes.to,e);this.camera.set(this.firstPose(t));let s=Math.min(...[i.low,i.high].map(o=>Pi(o,this.camera.up))),r=Pi(t.view.center,this.camera.up)-t.view.radius;this.floor=Math.min(s,r),this.flight=null}firstPose(t){let e=Sm(this.camera,t,El(this.nodes.to,Cn(t)));return this.covered(e)?this.wholePose(t,e):e}wholePose(t,e){let i=El(this.nodes.to,Cn(t)),s=.06*t.view.radius;for(let r=0;r<3;r++)i.low[r]-=s,i.high[r]+=s;return this.camera.fitted(i,e,this.strips())}fit(t={}){let{layout:e}=this.session;e&&!this.nodes.empty&&this.fly(this.wholePose(e,t))}uncover(){!this.lookPending&&this.covered(this.camera.pose)&&this.fit()}covered(t){let{layout:e}=this.session,i=this.card();if(!e||!i)return!1;let s=this.camera.at(t);for(let r=0;r<Cn(e);r++){let[o,a]=s.project(...fn(this.nodes.to.subarray(4*r,4*r+3)));if(o>i.left&&o<i.right&&a>i.top&&a<i.bottom)return!0}return!1}strips(){let t=this.card();if(!t)return{top:0,bottom:0};let e=this.camera.height-t.top;return t.bottom<e?{top:t.bottom,bottom:0}:{top:vy,bottom:e}}fly(t){matchMedia("(prefers-reduced-motion: reduce)").matches?this.camera.set(t):this.flight=new wl(this.camera.pose,t,performance.now())}setColouring(t){this.colouring=t,this.range=new Io,this.session.frame&&this.takeFrame(this.session.frame,!0)}setTheme(){this.theme=ku(),this.renderer.setTheme(this.theme),this.dirty=!0}resize(t,e){let i=this.camera.width/this.camera.height;this.camera.resize(t,e),this.renderer.resize(t,e,Math.min(2,devicePixelRatio||1)),Math.abs(t/e/i-1)>.3&&(this.lookPending=!0);let{layout:s,frame:r}=this.session;s&&r&&this.lookPending&&this.look(s),this.renderer.clear(),this.draw(!0)}tick(t){if(this.flight){let{pose:s,over:r}=this.flight.at(t);this.camera.set(s),r&&(this.flight=null)}let e=this.nodes.advance(performance.now());this.anchors.advance(performance.now());let i=this.camera.version!==this.cameraVersion;(e||i||this.dirty||this.marks.dirty)&&this.draw(e||this.dirty),this.session.acknowledge()}draw(t){let{layout:e}=this.session;if(!e||this.nodes.empty)return;this.dirty=this.marks.dirty=!1,this.cameraVersion=this.camera.version;let{markers:i,arrows:s}=this.marks.collect(),r=bm(this.camera,e,this.floor);this.spacing=r.spacing,this.renderer.draw({camera:this.camera,nodes:this.nodes.shown,moved:t,range:this.range,plain:this.colouring==="plain",dots:this.dots,pixels:Cn(e)>4e3?4:5.5,markers:i,arrows:s,trails:this.marks.trails,ground:r}),this.drawn++;for(let o of this.afterDraw)o()}screenOf(t,e=0){let i=4*(this.starts[e]+t),{shown:s}=this.nodes,[r,o,a]=this.camera.project(s[i],s[i+1],s[i+2]);return{x:r,y:o,depth:a}}};var Am="(max-width: 700px), (max-height: 500px)",Il=class{constructor(t,e,i){this.session=e,this.root=t;let s=(o,a)=>X(o,{className:a,id:a});this.barHost=s("header","bar"),this.meterHost=s("section","meter"),this.scene=s("main","scene"),this.panel=s("aside","panel"),this.graphHost=s("section","graphs"),this.footer=s("footer","controls");let r=X("canvas",{id:"view",tabIndex:0,"aria-label":"The ropes"});this.scene.append(r),t.replaceChildren(this.barHost,this.meterHost,this.scene,this.panel,this.graphHost,this.footer),this.graphHost.hidden=!0,this.stage=new Pl(e,i(r)),this.labels=new hl(this.stage,this.scene),this.notices=new fl(e,this.scene),this.legend=new ul(this.stage,this.scene),this.views=new Ml(this.stage,this.scene),this.graphs=new il(this.stage,this.graphHost),this.tools=new ml(this.stage,this.scene,o=>this.follow(o)),this.pointer=new Ua(this.stage,this.stage.renderer.canvas,{use:(o,a)=>this.tools.use(o,a),menu:(o,a,c)=>this.tools.menu(o,a,c)}),this.tools.pointer=this.pointer,this.meter=new dl(e,this.meterHost),this.controls=new ol(e,this.footer,()=>this.graphs.toggle()),this.tweak=new yl(e,this.panel),this.broken=new sl(e,this.scene,(...o)=>this.stage.showInstead(...o)),this.tour=new gl(e,this.scene),this.scenes=new pl(e,t),this.compare=new rl(this.stage,t,this.scene,o=>this.compareColours(o)),this.help=new al(t),this.keep=new ll(this.stage,t,this.notices),this.bar=new nl(this.barHost,{scenes:()=>this.scenes.open(),tour:()=>this.tour.start(),compare:()=>this.compare.open(),keep:o=>this.keep.open(o),help:()=>this.help.open(),theme:()=>this.toggleTheme(),panel:()=>this.togglePanel()}),this.keys=new Fa(e,this.stage.camera,this.shortcuts()),this.watchHand(),this.panel.hidden=matchMedia(Am).matches,new ResizeObserver(()=>this.resize()).observe(this.scene),this.resize(),e.on("hello",()=>this.hello()),e.on("layout",({scene:o})=>this.bar.show(o.name)),e.on("status",({address:o})=>this.writeAddress(o)),this.asked=!1,addEventListener("hashchange",()=>this.openAddress())}shortcuts(){return{" ":()=>this.controls.toggle(),".":()=>this.controls.doStep(),r:()=>this.controls.doReset(),f:()=>this.stage.fit(),g:()=>this.graphs.toggle(),p:()=>this.togglePanel(),t:()=>this.toggleTheme(),h:()=>this.help.open(),"?":()=>this.help.open()}}watchHand(){let{source:t}=this.session,e=t.send.bind(t);t.send=i=>{e(i),["drag","move","grab"].includes(i.type)&&this.tour.handMoved()}}hello(){let{session:t}=this,e=t.hello,i=this.stage.renderer.name==="webgl"?"WebGL":"Canvas 2D";this.help.version.textContent=`Ropewalk ${e.ropewalk}, drawn with ${i}.`,this.root.dataset.mode=e.mode,this.bar.compare.hidden=!t.can("compare"),this.bar.tour.hidden=!t.can("set"),this.bar.choose.disabled=!t.can("scene");let s=t.can("set");s||(this.panel.hidden=!0),this.bar.panel.hidden=!s,!this.asked&&location.hash.slice(1)!==e.address&&this.openAddress(),this.asked=!0,this.resize()}openAddress(){let{session:t}=this,e=location.hash.slice(1);e&&e!==t.status?.address&&t.can("scene")&&t.tell({type:"scene",address:e})}writeAddress(t){!this.session.source.base||!t||location.hash.slice(1)===t||history.replaceState(null,"",`#${t}`)}follow(t){this.stage.marks.toggleTrail(t),this.graphs.rebuild(),!this.graphs.open&&this.stage.marks.followed.size===1&&!matchMedia(Am).matches&&this.graphs.toggle(!0)}compareColours(t){this.legend.select.value=t?"plain":"tension",this.legend.choose()}togglePanel(){this.panel.hidden=!this.panel.hidden,this.resize()}toggleTheme(){Tl(document.documentElement.dataset.theme==="dark"?"light":"dark",!0),this.stage.setTheme(),this.graphs.rebuild()}resize(){this.root.classList.toggle("with-panel",!this.panel.hidden);let{clientWidth:t,clientHeight:e}=this.scene;t&&e&&this.stage.resize(t,e)}};function Rm(n){let{session:t,stage:e}=n;return{app:n,session:t,stage:e,get frames(){return t.frames},get drawn(){return e.drawn},get frame(){return t.frame?.number??-1},get time(){return t.frame?.time??NaN},get renderer(){return e.renderer.name},get state(){return t.connection!=="open"?t.connection:t.frame?t.broken?"broken":t.status?.playing?"playing":"paused":"waiting"},screenOf(i,s=0){let r=e.renderer.canvas.getBoundingClientRect(),{x:o,y:a}=e.screenOf(i,s);return{x:o+r.left,y:a+r.top}},nodeAt(i,s=0){let r=t.frame?.parts[s];return r?[...r.positions.subarray(3*i,3*i+3)]:null}}}var My=900,Sy=600,by=120,qr=class{constructor(t,e){this.app=t,this.read=e,this.timer=0,this.known="",this.until=-1,this.coarse=[],t.graphs.wanted=()=>this.want()}want(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>this.fill(),by)}async fill(){let{graphs:t,session:e,stage:i}=this.app,{layout:s,frame:r}=e;if(!t.open||!s||!r||r.steps<1)return;let[o,a]=[r.steps,r.time],c=Math.min(t.window,a),l=Math.min(o,Math.ceil(c*o/Math.max(a,1e-9))),h=`${s.layout} ${[...i.marks.followed]}`;(h!==this.known||o>this.until)&&(this.coarse=await this.samples(0,o,Sy,s),[this.known,this.until]=[h,o]);let u=await this.samples(o-l,l,My,s);if(e.layout!==s||!e.frame||e.frame.time<a)return;let d=u[0]?.time??a,{history:f}=t;f.clear();for(let{time:g,values:y}of this.coarse)g<d&&f.add(g,y);for(let{time:g,values:y}of u)f.add(g,y);t.take(e.frame),t.bounds()}async samples(t,e,i,s){let r=Math.max(1,Math.ceil(e/i)),o=[...this.app.stage.marks.followed];return(await this.read(t,Math.ceil(e/r),r)).filter(l=>!(l.flags&2)).map(l=>({time:l.time,values:el(s,l,o)}))}};var Cm=40;function Pm(n,t){let e=new qr(n,(...s)=>wy(t,...s));t.jumped=()=>{n.stage.marks.trails?.clear(),e.want()};let{about:i}=t.header;n.help.window.append(X("p",{className:"faint",id:"about"},i))}async function wy(n,t,e,i){let s=n.parts[n.layout],r=[];for(let o=0;o<e;o++){let a=t+o*i;a<s.first||a>=s.first+s.frames||(r.push(Nr(n.frame(a),s.layout)),o%Cm===Cm-1&&await new Promise(c=>setTimeout(c)))}return r}var Ey=.3;function Im(n){let{session:t,stage:e}=n,i=null,s=0;t.on("frame",({time:r})=>{if(t.hello?.mode!=="replay")return;i??=new qr(n,(...a)=>Ty(n,...a));let o=r<s||r>s+Ey*Math.max(1,t.status?.speed??1);s=r,o&&(e.marks.trails?.clear(),i.want())})}async function Ty({session:n},t,e,i){let s=n.layout;if(e<1)return[];let r=`replay/frames.bin?first=${t}&count=${e}&every=${i}`,o=await fetch(n.source.base+r).catch(()=>null);return o?.ok?Ay(await o.arrayBuffer(),s).map(a=>Nr(a,s)):[]}function Ay(n,t){let e=[];for(let i=n.byteLength;i>=t.bytes;i-=t.bytes){let s=n.slice(i-t.bytes,i);if(Oa(s)!==t.layout)break;e.push(s)}return e.reverse()}var qo=14,Lm=8;function Nm(n,t,e,i){for(let[s,r]of[[1,.25],[.75,.35],[.5,.5]]){let o=e.spacing*qo*s;n.beginPath();for(let a=0;a<48;a++){let c=2*Math.PI*a/48,l=ve(e.center,t.first,o*Math.cos(c)),[h,u,d]=t.project(...ve(l,t.second,o*Math.sin(c)));d>.02*t.pose.distance&&n.lineTo(h,u)}n.fillStyle=hi(i.ground,r),n.fill()}}function Dm(n,t,e,i){n.lineWidth=1;let s=[[],[],[]];for(let[r,o]of[[t.first,t.second],[t.second,t.first]])for(let a=-qo;a<=qo;a++){let c=ve(e.center,r,a*e.spacing);for(let l=0;l<Lm;l++){let[h,u]=[l,l+1].map(y=>(2*y/Lm-1)*qo),d=Math.hypot(a,(h+u)/2)/qo;if(d>.95)continue;let f=t.project(...ve(c,o,h*e.spacing)),g=t.project(...ve(c,o,u*e.spacing));f[2]<=.02*t.pose.distance||g[2]<=.02*t.pose.distance||s[d<.45?0:d<.7?1:2].push(f[0],f[1],g[0],g[1])}}s.forEach((r,o)=>{n.strokeStyle=hi(i.grid,[.8,.5,.2][o]),n.beginPath();for(let a=0;a<r.length;a+=4)n.moveTo(r[a],r[a+1]),n.lineTo(r[a+2],r[a+3]);n.stroke()})}function Fm(n,t,e){let[i,s,r]=t.project(e.x,e.y,e.z);if(r<=0)return;let o=.5*Math.max(e.pixels,e.size*t.focal/r),a=e.colour.map(c=>.72*c);if(n.beginPath(),e.kind==="ring"){n.arc(i,s,o-1.2,0,2*Math.PI),n.lineWidth=2.4,n.strokeStyle=hi(e.colour),n.stroke();return}if(e.kind==="square"){let c=1.68*o;n.roundRect(i-c/2,s-c/2,c,c,.22*o)}else n.arc(i,s,o,0,2*Math.PI);n.fillStyle=hi(e.colour),n.fill(),n.lineWidth=1.5,n.strokeStyle=hi(a),n.stroke()}function Um(n,t,e){let[i,s,r]=t.project(e.from[0],e.from[1],e.from[2]),[o,a,c]=t.project(e.to[0],e.to[1],e.to[2]);if(r<=0||c<=0)return;let l=Math.hypot(o-i,a-s);if(l<1)return;let[h,u]=[(o-i)/l,(a-s)/l],d=e.head?Math.min(.5*l,5.5*e.pixels):0;if(n.lineCap="butt",n.lineWidth=e.pixels,n.strokeStyle=n.fillStyle=hi(e.colour),n.beginPath(),n.moveTo(i,s),n.lineTo(o-d*h,a-d*u),n.stroke(),n.lineCap="round",!d)return;let f=2.2*e.pixels;n.beginPath(),n.moveTo(o,a),n.lineTo(o-d*h-f*u,a-d*u+f*h),n.lineTo(o-d*h+f*u,a-d*u-f*h),n.fill()}var Yo=32,Bu=6,Zo=class{constructor(t){let e=t.getContext("2d",{alpha:!1});if(!e)throw new Error("no canvas to draw on");this.name="canvas",this.canvas=t,this.context=e;let i=Ir();this.colours=Array.from({length:Yo},(s,r)=>hi(i[Math.round(r/(Yo-1)*(i.length-1))])),this.shape={nodes:0,ropes:[]},this.seen=new Float32Array(0),this.batch=new Uint8Array(0),this.ratio=1,this.theme=null}setShape(t){this.shape=t,this.seen=new Float32Array(3*t.nodes),this.batch=new Uint8Array(t.nodes)}setTheme(t){this.theme=t}resize(t,e,i){this.canvas.width=Math.round(t*i),this.canvas.height=Math.round(e*i),this.ratio=i}clear(){let{context:t,canvas:e,theme:i}=this;t.setTransform(1,0,0,1,0,0),t.fillStyle=i?hi(i.background):"#888888",t.fillRect(0,0,e.width,e.height)}draw(t){let{context:e,theme:i}=this;if(i){if(this.clear(),e.setTransform(this.ratio,0,0,this.ratio,0,0),e.lineJoin="round",e.lineCap="round",t.ground){t.ground.solid&&Nm(e,t.camera,t.ground,i),Dm(e,t.camera,t.ground,i),this.project(t,t.ground.height),e.strokeStyle=hi(i.shadow,i.dark?.5:.16);for(let s of this.shape.ropes)e.lineWidth=this.width(s,t)*1.2,e.beginPath(),this.path(s),e.stroke()}this.project(t,null),t.trails&&!t.trails.empty&&this.trails(t),this.ropes(t),t.dots&&this.dots(i);for(let s of t.markers)Fm(e,t.camera,s);for(let s of t.arrows)Um(e,t.camera,s)}}project(t,e){let{seen:i}=this,{camera:s,nodes:r}=t,o=s.view,[a,c,l]=s.up,[h,u,d]=[s.width/2,s.height/2,s.focal];for(let f=0;f<this.shape.nodes;f++){let[g,y,m]=[r[4*f],r[4*f+1],r[4*f+2]];if(e!==null){let A=g*a+y*c+m*l-e;g-=A*a,y-=A*c,m-=A*l}let p=-(o[2]*g+o[6]*y+o[10]*m+o[14]),v=d/Math.max(p,1e-9);i[3*f]=h+(o[0]*g+o[4]*y+o[8]*m+o[12])*v,i[3*f+1]=u-(o[1]*g+o[5]*y+o[9]*m+o[13])*v,i[3*f+2]=p}}width(t,e){let i=Math.max(1e-9,this.seen[3*(t.first+(t.count>>1))+2]);return Math.max(e.pixels,2*t.radius*e.camera.focal/i)}path(t){let{context:e,seen:i}=this,s=!1;for(let r=t.first;r<t.first+t.count;r++){let o=i[3*r+2]<=0;s&&!o?e.lineTo(i[3*r],i[3*r+1]):e.moveTo(i[3*r],i[3*r+1]),s=!o}}ropes(t){let{context:e}=this,i=this.theme;for(let s of this.shape.ropes){let r=this.width(s,t);if(t.plain){e.lineWidth=r,e.strokeStyle=hi(s.colour),e.beginPath(),this.path(s),e.stroke();continue}this.coloured(s,t,r),r>6&&(e.lineWidth=r*.25,e.strokeStyle=i.dark?"rgba(255, 255, 255, 0.18)":"rgba(255, 255, 255, 0.3)",e.beginPath(),this.path(s),e.stroke())}}coloured(t,e,i){let{context:s,seen:r,batch:o}=this,{low:a,high:c}=e.range,l=Yo/Math.max(c-a,1e-30),h=t.first+t.count-1;for(let u=t.first;u<h;u++){let d=.5*(e.nodes[4*u+3]+e.nodes[4*u+7]);o[u]=Math.min(Yo-1,Math.max(0,Math.floor((d-a)*l)))}s.lineWidth=i;for(let u=0;u<Yo;u++){let d=!1,f=!1;for(let g=t.first;g<h;g++){if(!(o[g]===u)||r[3*g+2]<=0||r[3*g+5]<=0){d=!1;continue}f||s.beginPath(),d||s.moveTo(r[3*g],r[3*g+1]),s.lineTo(r[3*g+3],r[3*g+4]),d=f=!0}f&&(s.strokeStyle=this.colours[u],s.stroke())}}dots(t){let{context:e,seen:i}=this;e.fillStyle=hi(t.node),e.beginPath();for(let s=0;s<this.shape.nodes;s++)i[3*s+2]<=0||(e.moveTo(i[3*s]+2.2,i[3*s+1]),e.arc(i[3*s],i[3*s+1],2.2,0,2*Math.PI));e.fill()}trails(t){let e=t.trails,{context:i}=this;i.lineWidth=2.5;let s=360/Bu;e.nodes.forEach((r,o)=>{for(let a=0;a<Bu;a++){i.strokeStyle=hi(e.colours[o],.7*((a+1)/Bu)**2),i.beginPath();for(let c=a*s;c<=Math.min((a+1)*s,359);c++){let l=4*(o*360+(e.head+c)%360),h=e.points,[u,d,f]=t.camera.project(h[l],h[l+1],h[l+2]);f>0&&i.lineTo(u,d)}i.stroke()}})}dispose(){}};var og=0,pd=1,ag=2;var ga=1,lg=2,go=3,Hs=0,Gi=1,Sn=2,ur=0,_o=1,md=2,gd=3,_d=4,cg=5;var dr=100,hg=101,ug=102,dg=103,fg=104,pg=200,mg=201,gg=202,_g=203,xd=204,vd=205,xg=206,vg=207,yg=208,Mg=209,Sg=210,bg=211,wg=212,Eg=213,Tg=214,ic=0,nc=1,sc=2,lo=3,rc=4,oc=5,ac=6,lc=7,yd=0,Ag=1,Rg=2,Qn=0,Md=1,Sd=2,bd=3,wd=4,Ed=5,Td=6,Ad=7;var Rd=300,fr=301,xo=302,Nc=303,Dc=304,cc=1e3,Zn=1001,hc=1002,Ai=1003,Cg=1004;var _a=1005;var Ri=1006,Fc=1007;var xs=1008;var cn=1009,Cd=1010,Pd=1011,vo=1012,Uc=1013,Fn=1014,Wi=1015,Un=1016,Oc=1017,kc=1018,pr=1020,Id=35902,Ld=35899,Nd=1021,Dd=1022,Xi=1023,ms=1026,vs=1027,Fd=1028,Bc=1029,Gs=1030,zc=1031;var Vc=1033,xa=33776,va=33777,ya=33778,Ma=33779,Hc=35840,Gc=35841,Wc=35842,Xc=35843,$c=36196,qc=37492,Yc=37496,Zc=37488,Jc=37489,Sa=37490,Kc=37491,jc=37808,Qc=37809,th=37810,eh=37811,ih=37812,nh=37813,sh=37814,rh=37815,oh=37816,ah=37817,lh=37818,ch=37819,hh=37820,uh=37821,dh=36492,fh=36494,ph=36495,mh=36283,gh=36284,ba=36285,_h=36286;var ea=2300,uc=2301,tc=2302,ad=2303,ld=2400,cd=2401,hd=2402;var Pg=3200;var Ud=0,Ig=1,ys="",sn="srgb",Fs="srgb-linear",ia="linear",Ee="srgb";var ec=7680;var Lg=519,Ng=512,Dg=513,Fg=514,Od=515,Ug=516,Og=517,kd=518,Bd=519,kg=35044,wa=35048;var Ea="300 es",yn=2e3,na=2001;function Ry(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Cy(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function sa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Bg(){let n=sa("canvas");return n.style.display="block",n}var Om={},co=null;function zd(...n){let t="THREE."+n.shift();co?co("log",t,...n):console.log(t,...n)}function zg(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Yt(...n){n=zg(n);let t="THREE."+n.shift();if(co)co("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function jt(...n){n=zg(n);let t="THREE."+n.shift();if(co)co("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function ta(...n){let t=n.join(" ");t in Om||(Om[t]=!0,Yt(...n))}function Vg(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Hg={[ic]:ic,[sc]:ac,[rc]:rc,[lo]:oc,[nc]:nc,[ac]:sc,[lc]:lc,[oc]:lo},Jn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Di=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var zu=Math.PI/180,dc=180/Math.PI;function Ta(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Di[n&255]+Di[n>>8&255]+Di[n>>16&255]+Di[n>>24&255]+"-"+Di[t&255]+Di[t>>8&255]+"-"+Di[t>>16&15|64]+Di[t>>24&255]+"-"+Di[e&63|128]+Di[e>>8&255]+"-"+Di[e>>16&255]+Di[e>>24&255]+Di[i&255]+Di[i>>8&255]+Di[i>>16&255]+Di[i>>24&255]).toLowerCase()}function ge(n,t,e){return Math.max(t,Math.min(e,n))}function Py(n,t){return(n%t+t)%t}function Vu(n,t,e){return(1-e)*n+e*t}function Gg(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Vd(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Iy(n,t){if(t.constructor===Float32Array)return n;let e=Vd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Ly(n,t){if(t.constructor===Float32Array)return n;let e=Vd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var xe=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ge(this.x,t.x,e.x),this.y=ge(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ge(this.x,t,e),this.y=ge(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ge(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ge(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Kn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let c=i[s+0],l=i[s+1],h=i[s+2],u=i[s+3],d=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(u!==y||c!==d||l!==f||h!==g){let m=c*d+l*f+h*g+u*y;m<0&&(d=-d,f=-f,g=-g,y=-y,m=-m);let p=1-a;if(m<.9995){let v=Math.acos(m),A=Math.sin(v);p=Math.sin(p*v)/A,a=Math.sin(a*v)/A,c=c*p+d*a,l=l*p+f*a,h=h*p+g*a,u=u*p+y*a}else{c=c*p+d*a,l=l*p+f*a,h=h*p+g*a,u=u*p+y*a;let v=1/Math.sqrt(c*c+l*l+h*h+u*u);c*=v,l*=v,h*=v,u*=v}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],c=i[s+1],l=i[s+2],h=i[s+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return t[e]=a*g+h*u+c*f-l*d,t[e+1]=c*g+h*d+l*u-a*f,t[e+2]=l*g+h*f+a*d-c*u,t[e+3]=h*g-a*u-c*d-l*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(i/2),h=a(s/2),u=a(r/2),d=c(i/2),f=c(s/2),g=c(r/2);switch(o){case"XYZ":this._x=d*h*u+l*f*g,this._y=l*f*u-d*h*g,this._z=l*h*g+d*f*u,this._w=l*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+l*f*g,this._y=l*f*u-d*h*g,this._z=l*h*g-d*f*u,this._w=l*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-l*f*g,this._y=l*f*u+d*h*g,this._z=l*h*g+d*f*u,this._w=l*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-l*f*g,this._y=l*f*u+d*h*g,this._z=l*h*g-d*f*u,this._w=l*h*u+d*f*g;break;case"YZX":this._x=d*h*u+l*f*g,this._y=l*f*u+d*h*g,this._z=l*h*g-d*f*u,this._w=l*h*u-d*f*g;break;case"XZY":this._x=d*h*u-l*f*g,this._y=l*f*u-d*h*g,this._z=l*h*g+d*f*u,this._w=l*h*u+d*f*g;break;default:Yt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],h=e[6],u=e[10],d=i+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(i>a&&i>u){let f=2*Math.sqrt(1+i-a-u);this._w=(h-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>u){let f=2*Math.sqrt(1+a-i-u);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+h)/f}else{let f=2*Math.sqrt(1+u-i-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ge(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,h=e._w;return this._x=i*h+o*a+s*l-r*c,this._y=s*h+o*c+r*a-i*l,this._z=r*h+o*l+i*c-s*a,this._w=o*h-i*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},K=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(km.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(km.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*i),h=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+c*l+o*u-a*h,this.y=i+c*h+a*l-r*u,this.z=s+c*u+r*h-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ge(this.x,t.x,e.x),this.y=ge(this.y,t.y,e.y),this.z=ge(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ge(this.x,t,e),this.y=ge(this.y,t,e),this.z=ge(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ge(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-i*c,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Hu.copy(this).projectOnVector(t),this.sub(Hu)}reflect(t){return this.sub(Hu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ge(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Hu=new K,km=new Kn,Qt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l)}set(t,e,i,s,r,o,a,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=c,h[6]=i,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],h=i[4],u=i[7],d=i[2],f=i[5],g=i[8],y=s[0],m=s[3],p=s[6],v=s[1],A=s[4],S=s[7],C=s[2],T=s[5],x=s[8];return r[0]=o*y+a*v+c*C,r[3]=o*m+a*A+c*T,r[6]=o*p+a*S+c*x,r[1]=l*y+h*v+u*C,r[4]=l*m+h*A+u*T,r[7]=l*p+h*S+u*x,r[2]=d*y+f*v+g*C,r[5]=d*m+f*A+g*T,r[8]=d*p+f*S+g*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8];return e*o*h-e*a*l-i*r*h+i*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=h*o-a*l,d=a*c-h*r,f=l*r-o*c,g=e*u+i*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return t[0]=u*y,t[1]=(s*l-h*i)*y,t[2]=(a*i-s*o)*y,t[3]=d*y,t[4]=(h*e-s*c)*y,t[5]=(s*r-a*e)*y,t[6]=f*y,t[7]=(i*c-l*e)*y,t[8]=(o*e-i*r)*y,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(i*c,i*l,-i*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return ta("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Gu.makeScale(t,e)),this}rotate(t){return ta("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Gu.makeRotation(-t)),this}translate(t,e){return ta("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Gu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Gu=new Qt,Bm=new Qt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),zm=new Qt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ny(){let n={enabled:!0,workingColorSpace:Fs,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ee&&(s.r=ps(s.r),s.g=ps(s.g),s.b=ps(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ee&&(s.r=ao(s.r),s.g=ao(s.g),s.b=ao(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ys?ia:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Fs]:{primaries:t,whitePoint:i,transfer:ia,toXYZ:Bm,fromXYZ:zm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:sn},outputColorSpaceConfig:{drawingBufferColorSpace:sn}},[sn]:{primaries:t,whitePoint:i,transfer:Ee,toXYZ:Bm,fromXYZ:zm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:sn}}}),n}var pe=Ny();function ps(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ao(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Yr,fc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Yr===void 0&&(Yr=sa("canvas")),Yr.width=t.width,Yr.height=t.height;let s=Yr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Yr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=sa("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ps(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ps(e[i]/255)*255):e[i]=ps(e[i]);return{data:e,width:t.width,height:t.height}}else return Yt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Dy=0,ho=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Dy++}),this.uuid=Ta(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Wu(s[o].image)):r.push(Wu(s[o]))}else r=Wu(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Wu(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?fc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Yt("Texture: Unable to serialize Texture."),{})}var Fy=0,Xu=new K,qi=class n extends Jn{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Zn,s=Zn,r=Ri,o=xs,a=Xi,c=cn,l=n.DEFAULT_ANISOTROPY,h=ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Fy++}),this.uuid=Ta(),this.name="",this.source=new ho(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new xe(0,0),this.repeat=new xe(1,1),this.center=new xe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Qt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Xu).x}get height(){return this.source.getSize(Xu).y}get depth(){return this.source.getSize(Xu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Yt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Yt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Rd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case cc:t.x=t.x-Math.floor(t.x);break;case Zn:t.x=t.x<0?0:1;break;case hc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case cc:t.y=t.y-Math.floor(t.y);break;case Zn:t.y=t.y<0?0:1;break;case hc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};qi.DEFAULT_IMAGE=null;qi.DEFAULT_MAPPING=Rd;qi.DEFAULT_ANISOTROPY=1;var Ie=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,c=t.elements,l=c[0],h=c[4],u=c[8],d=c[1],f=c[5],g=c[9],y=c[2],m=c[6],p=c[10];if(Math.abs(h-d)<.01&&Math.abs(u-y)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+y)<.1&&Math.abs(g+m)<.1&&Math.abs(l+f+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(l+1)/2,S=(f+1)/2,C=(p+1)/2,T=(h+d)/4,x=(u+y)/4,E=(g+m)/4;return A>S&&A>C?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=T/i,r=x/i):S>C?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=T/s,r=E/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=x/r,s=E/r),this.set(i,s,r,e),this}let v=Math.sqrt((m-g)*(m-g)+(u-y)*(u-y)+(d-h)*(d-h));return Math.abs(v)<.001&&(v=1),this.x=(m-g)/v,this.y=(u-y)/v,this.z=(d-h)/v,this.w=Math.acos((l+f+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ge(this.x,t.x,e.x),this.y=ge(this.y,t.y,e.y),this.z=ge(this.z,t.z,e.z),this.w=ge(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ge(this.x,t,e),this.y=ge(this.y,t,e),this.z=ge(this.z,t,e),this.w=ge(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ge(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},pc=class extends Jn{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ri,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Ie(0,0,t,e),this.scissorTest=!1,this.viewport=new Ie(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new qi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ri,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ho(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},on=class extends pc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},ra=class extends qi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Ai,this.minFilter=Ai,this.wrapR=Zn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var mc=class extends qi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Ai,this.minFilter=Ai,this.wrapR=Zn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Ue=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,c,l,h,u,d,f,g,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l,h,u,d,f,g,y,m)}set(t,e,i,s,r,o,a,c,l,h,u,d,f,g,y,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=c,p[2]=l,p[6]=h,p[10]=u,p[14]=d,p[3]=f,p[7]=g,p[11]=y,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Zr.setFromMatrixColumn(t,0).length(),r=1/Zr.setFromMatrixColumn(t,1).length(),o=1/Zr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,g=a*h,y=a*u;e[0]=c*h,e[4]=-c*u,e[8]=l,e[1]=f+g*l,e[5]=d-y*l,e[9]=-a*c,e[2]=y-d*l,e[6]=g+f*l,e[10]=o*c}else if(t.order==="YXZ"){let d=c*h,f=c*u,g=l*h,y=l*u;e[0]=d+y*a,e[4]=g*a-f,e[8]=o*l,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-g,e[6]=y+d*a,e[10]=o*c}else if(t.order==="ZXY"){let d=c*h,f=c*u,g=l*h,y=l*u;e[0]=d-y*a,e[4]=-o*u,e[8]=g+f*a,e[1]=f+g*a,e[5]=o*h,e[9]=y-d*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let d=o*h,f=o*u,g=a*h,y=a*u;e[0]=c*h,e[4]=g*l-f,e[8]=d*l+y,e[1]=c*u,e[5]=y*l+d,e[9]=f*l-g,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let d=o*c,f=o*l,g=a*c,y=a*l;e[0]=c*h,e[4]=y-d*u,e[8]=g*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-l*h,e[6]=f*u+g,e[10]=d-y*u}else if(t.order==="XZY"){let d=o*c,f=o*l,g=a*c,y=a*l;e[0]=c*h,e[4]=-u,e[8]=l*h,e[1]=d*u+y,e[5]=o*h,e[9]=f*u-g,e[2]=g*u-f,e[6]=a*h,e[10]=y*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Uy,t,Oy)}lookAt(t,e,i){let s=this.elements;return en.subVectors(t,e),en.lengthSq()===0&&(en.z=1),en.normalize(),Cs.crossVectors(i,en),Cs.lengthSq()===0&&(Math.abs(i.z)===1?en.x+=1e-4:en.z+=1e-4,en.normalize(),Cs.crossVectors(i,en)),Cs.normalize(),Ll.crossVectors(en,Cs),s[0]=Cs.x,s[4]=Ll.x,s[8]=en.x,s[1]=Cs.y,s[5]=Ll.y,s[9]=en.y,s[2]=Cs.z,s[6]=Ll.z,s[10]=en.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],h=i[1],u=i[5],d=i[9],f=i[13],g=i[2],y=i[6],m=i[10],p=i[14],v=i[3],A=i[7],S=i[11],C=i[15],T=s[0],x=s[4],E=s[8],k=s[12],N=s[1],I=s[5],V=s[9],G=s[13],D=s[2],H=s[6],Z=s[10],z=s[14],ct=s[3],J=s[7],Q=s[11],st=s[15];return r[0]=o*T+a*N+c*D+l*ct,r[4]=o*x+a*I+c*H+l*J,r[8]=o*E+a*V+c*Z+l*Q,r[12]=o*k+a*G+c*z+l*st,r[1]=h*T+u*N+d*D+f*ct,r[5]=h*x+u*I+d*H+f*J,r[9]=h*E+u*V+d*Z+f*Q,r[13]=h*k+u*G+d*z+f*st,r[2]=g*T+y*N+m*D+p*ct,r[6]=g*x+y*I+m*H+p*J,r[10]=g*E+y*V+m*Z+p*Q,r[14]=g*k+y*G+m*z+p*st,r[3]=v*T+A*N+S*D+C*ct,r[7]=v*x+A*I+S*H+C*J,r[11]=v*E+A*V+S*Z+C*Q,r[15]=v*k+A*G+S*z+C*st,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],h=t[2],u=t[6],d=t[10],f=t[14],g=t[3],y=t[7],m=t[11],p=t[15],v=c*f-l*d,A=a*f-l*u,S=a*d-c*u,C=o*f-l*h,T=o*d-c*h,x=o*u-a*h;return e*(y*v-m*A+p*S)-i*(g*v-m*C+p*T)+s*(g*A-y*C+p*x)-r*(g*S-y*T+m*x)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],h=t[10];return e*(o*h-a*l)-i*(r*h-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=t[9],d=t[10],f=t[11],g=t[12],y=t[13],m=t[14],p=t[15],v=e*a-i*o,A=e*c-s*o,S=e*l-r*o,C=i*c-s*a,T=i*l-r*a,x=s*l-r*c,E=h*y-u*g,k=h*m-d*g,N=h*p-f*g,I=u*m-d*y,V=u*p-f*y,G=d*p-f*m,D=v*G-A*V+S*I+C*N-T*k+x*E;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/D;return t[0]=(a*G-c*V+l*I)*H,t[1]=(s*V-i*G-r*I)*H,t[2]=(y*x-m*T+p*C)*H,t[3]=(d*T-u*x-f*C)*H,t[4]=(c*N-o*G-l*k)*H,t[5]=(e*G-s*N+r*k)*H,t[6]=(m*S-g*x-p*A)*H,t[7]=(h*x-d*S+f*A)*H,t[8]=(o*V-a*N+l*E)*H,t[9]=(i*N-e*V-r*E)*H,t[10]=(g*T-y*S+p*v)*H,t[11]=(u*S-h*T-f*v)*H,t[12]=(a*k-o*I-c*E)*H,t[13]=(e*I-i*k+s*E)*H,t[14]=(y*A-g*C-m*v)*H,t[15]=(h*C-u*A+d*v)*H,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,c=t.z,l=r*o,h=r*a;return this.set(l*o+i,l*a-s*c,l*c+s*a,0,l*a+s*c,h*a+i,h*c-s*o,0,l*c-s*a,h*c+s*o,r*c*c+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,h=o+o,u=a+a,d=r*l,f=r*h,g=r*u,y=o*h,m=o*u,p=a*u,v=c*l,A=c*h,S=c*u,C=i.x,T=i.y,x=i.z;return s[0]=(1-(y+p))*C,s[1]=(f+S)*C,s[2]=(g-A)*C,s[3]=0,s[4]=(f-S)*T,s[5]=(1-(d+p))*T,s[6]=(m+v)*T,s[7]=0,s[8]=(g+A)*x,s[9]=(m-v)*x,s[10]=(1-(d+y))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Zr.set(s[0],s[1],s[2]).length(),a=Zr.set(s[4],s[5],s[6]).length(),c=Zr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),In.copy(this);let l=1/o,h=1/a,u=1/c;return In.elements[0]*=l,In.elements[1]*=l,In.elements[2]*=l,In.elements[4]*=h,In.elements[5]*=h,In.elements[6]*=h,In.elements[8]*=u,In.elements[9]*=u,In.elements[10]*=u,e.setFromRotationMatrix(In),i.x=o,i.y=a,i.z=c,this}makePerspective(t,e,i,s,r,o,a=yn,c=!1){let l=this.elements,h=2*r/(e-t),u=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),g,y;if(c)g=r/(o-r),y=o*r/(o-r);else if(a===yn)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===na)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=y,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=yn,c=!1){let l=this.elements,h=2/(e-t),u=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),g,y;if(c)g=1/(o-r),y=o/(o-r);else if(a===yn)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===na)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=u,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=g,l[14]=y,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Zr=new K,In=new Ue,Uy=new K(0,0,0),Oy=new K(1,1,1),Cs=new K,Ll=new K,en=new K,Vm=new Ue,Hm=new Kn,Us=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(ge(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-ge(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ge(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-ge(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(ge(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ge(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Yt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Vm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Vm,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Hm.setFromEuler(this),this.setFromQuaternion(Hm,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Us.DEFAULT_ORDER="XYZ";var oa=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},ky=0,Gm=new K,Jr=new Kn,cs=new Ue,Nl=new K,Jo=new K,By=new K,zy=new Kn,Wm=new K(1,0,0),Xm=new K(0,1,0),$m=new K(0,0,1),qm={type:"added"},Vy={type:"removed"},Kr={type:"childadded",child:null},$u={type:"childremoved",child:null},an=class n extends Jn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:ky++}),this.uuid=Ta(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new K,e=new Us,i=new Kn,s=new K(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ue},normalMatrix:{value:new Qt}}),this.matrix=new Ue,this.matrixWorld=new Ue,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new oa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Jr.setFromAxisAngle(t,e),this.quaternion.multiply(Jr),this}rotateOnWorldAxis(t,e){return Jr.setFromAxisAngle(t,e),this.quaternion.premultiply(Jr),this}rotateX(t){return this.rotateOnAxis(Wm,t)}rotateY(t){return this.rotateOnAxis(Xm,t)}rotateZ(t){return this.rotateOnAxis($m,t)}translateOnAxis(t,e){return Gm.copy(t).applyQuaternion(this.quaternion),this.position.add(Gm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Wm,t)}translateY(t){return this.translateOnAxis(Xm,t)}translateZ(t){return this.translateOnAxis($m,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(cs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Nl.copy(t):Nl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Jo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?cs.lookAt(Jo,Nl,this.up):cs.lookAt(Nl,Jo,this.up),this.quaternion.setFromRotationMatrix(cs),s&&(cs.extractRotation(s.matrixWorld),Jr.setFromRotationMatrix(cs),this.quaternion.premultiply(Jr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(jt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(qm),Kr.child=t,this.dispatchEvent(Kr),Kr.child=null):jt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Vy),$u.child=t,this.dispatchEvent($u),$u.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),cs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),cs.multiply(t.parent.matrixWorld)),t.applyMatrix4(cs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(qm),Kr.child=t,this.dispatchEvent(Kr),Kr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Jo,t,By),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Jo,zy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let u=c[l];r(t.shapes,u)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};an.DEFAULT_UP=new K(0,1,0);an.DEFAULT_MATRIX_AUTO_UPDATE=!0;an.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var or=class extends an{constructor(){super(),this.isGroup=!0,this.type="Group"}},Hy={type:"move"},uo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new or,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new or,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new K,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new K),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new or,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new K,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new K,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let y of t.hand.values()){let m=e.getJointPose(y,i),p=this._getHandJoint(l,y);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=l.joints["index-finger-tip"],u=l.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;l.inputState.pinching&&d>f+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=f-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Hy)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new or;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Wg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ps={h:0,s:0,l:0},Dl={h:0,s:0,l:0};function qu(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var me=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=sn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,pe.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=pe.workingColorSpace){return this.r=t,this.g=e,this.b=i,pe.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=pe.workingColorSpace){if(t=Py(t,1),e=ge(e,0,1),i=ge(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=qu(o,r,t+1/3),this.g=qu(o,r,t),this.b=qu(o,r,t-1/3)}return pe.colorSpaceToWorking(this,s),this}setStyle(t,e=sn){function i(r){r!==void 0&&parseFloat(r)<1&&Yt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Yt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Yt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=sn){let i=Wg[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Yt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ps(t.r),this.g=ps(t.g),this.b=ps(t.b),this}copyLinearToSRGB(t){return this.r=ao(t.r),this.g=ao(t.g),this.b=ao(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=sn){return pe.workingToColorSpace(Fi.copy(this),t),Math.round(ge(Fi.r*255,0,255))*65536+Math.round(ge(Fi.g*255,0,255))*256+Math.round(ge(Fi.b*255,0,255))}getHexString(t=sn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=pe.workingColorSpace){pe.workingToColorSpace(Fi.copy(this),e);let i=Fi.r,s=Fi.g,r=Fi.b,o=Math.max(i,s,r),a=Math.min(i,s,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let u=o-a;switch(l=h<=.5?u/(o+a):u/(2-o-a),o){case i:c=(s-r)/u+(s<r?6:0);break;case s:c=(r-i)/u+2;break;case r:c=(i-s)/u+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=pe.workingColorSpace){return pe.workingToColorSpace(Fi.copy(this),e),t.r=Fi.r,t.g=Fi.g,t.b=Fi.b,t}getStyle(t=sn){pe.workingToColorSpace(Fi.copy(this),t);let e=Fi.r,i=Fi.g,s=Fi.b;return t!==sn?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Ps),this.setHSL(Ps.h+t,Ps.s+e,Ps.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Ps),t.getHSL(Dl);let i=Vu(Ps.h,Dl.h,e),s=Vu(Ps.s,Dl.s,e),r=Vu(Ps.l,Dl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Fi=new me;me.NAMES=Wg;var aa=class extends an{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Us,this.environmentIntensity=1,this.environmentRotation=new Us,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ln=new K,hs=new K,Yu=new K,us=new K,jr=new K,Qr=new K,Ym=new K,Zu=new K,Ju=new K,Ku=new K,ju=new Ie,Qu=new Ie,td=new Ie,Ds=class n{constructor(t=new K,e=new K,i=new K){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ln.subVectors(t,e),s.cross(Ln);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ln.subVectors(s,e),hs.subVectors(i,e),Yu.subVectors(t,e);let o=Ln.dot(Ln),a=Ln.dot(hs),c=Ln.dot(Yu),l=hs.dot(hs),h=hs.dot(Yu),u=o*l-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(l*c-a*h)*d,g=(o*h-a*c)*d;return r.set(1-f-g,g,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,us)===null?!1:us.x>=0&&us.y>=0&&us.x+us.y<=1}static getInterpolation(t,e,i,s,r,o,a,c){return this.getBarycoord(t,e,i,s,us)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,us.x),c.addScaledVector(o,us.y),c.addScaledVector(a,us.z),c)}static getInterpolatedAttribute(t,e,i,s,r,o){return ju.setScalar(0),Qu.setScalar(0),td.setScalar(0),ju.fromBufferAttribute(t,e),Qu.fromBufferAttribute(t,i),td.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(ju,r.x),o.addScaledVector(Qu,r.y),o.addScaledVector(td,r.z),o}static isFrontFacing(t,e,i,s){return Ln.subVectors(i,e),hs.subVectors(t,e),Ln.cross(hs).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ln.subVectors(this.c,this.b),hs.subVectors(this.a,this.b),Ln.cross(hs).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;jr.subVectors(s,i),Qr.subVectors(r,i),Zu.subVectors(t,i);let c=jr.dot(Zu),l=Qr.dot(Zu);if(c<=0&&l<=0)return e.copy(i);Ju.subVectors(t,s);let h=jr.dot(Ju),u=Qr.dot(Ju);if(h>=0&&u<=h)return e.copy(s);let d=c*u-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),e.copy(i).addScaledVector(jr,o);Ku.subVectors(t,r);let f=jr.dot(Ku),g=Qr.dot(Ku);if(g>=0&&f<=g)return e.copy(r);let y=f*l-c*g;if(y<=0&&l>=0&&g<=0)return a=l/(l-g),e.copy(i).addScaledVector(Qr,a);let m=h*g-f*u;if(m<=0&&u-h>=0&&f-g>=0)return Ym.subVectors(r,s),a=(u-h)/(u-h+(f-g)),e.copy(s).addScaledVector(Ym,a);let p=1/(m+y+d);return o=y*p,a=d*p,e.copy(i).addScaledVector(jr,o).addScaledVector(Qr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Os=class{constructor(t=new K(1/0,1/0,1/0),e=new K(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Nn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Nn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Nn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Nn):Nn.fromBufferAttribute(r,o),Nn.applyMatrix4(t.matrixWorld),this.expandByPoint(Nn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Fl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Fl.copy(i.boundingBox)),Fl.applyMatrix4(t.matrixWorld),this.union(Fl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Nn),Nn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ko),Ul.subVectors(this.max,Ko),to.subVectors(t.a,Ko),eo.subVectors(t.b,Ko),io.subVectors(t.c,Ko),Is.subVectors(eo,to),Ls.subVectors(io,eo),ir.subVectors(to,io);let e=[0,-Is.z,Is.y,0,-Ls.z,Ls.y,0,-ir.z,ir.y,Is.z,0,-Is.x,Ls.z,0,-Ls.x,ir.z,0,-ir.x,-Is.y,Is.x,0,-Ls.y,Ls.x,0,-ir.y,ir.x,0];return!ed(e,to,eo,io,Ul)||(e=[1,0,0,0,1,0,0,0,1],!ed(e,to,eo,io,Ul))?!1:(Ol.crossVectors(Is,Ls),e=[Ol.x,Ol.y,Ol.z],ed(e,to,eo,io,Ul))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Nn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Nn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ds[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ds[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ds[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ds[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ds[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ds[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ds[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ds[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ds),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ds=[new K,new K,new K,new K,new K,new K,new K,new K],Nn=new K,Fl=new Os,to=new K,eo=new K,io=new K,Is=new K,Ls=new K,ir=new K,Ko=new K,Ul=new K,Ol=new K,nr=new K;function ed(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){nr.fromArray(n,r);let a=s.x*Math.abs(nr.x)+s.y*Math.abs(nr.y)+s.z*Math.abs(nr.z),c=t.dot(nr),l=e.dot(nr),h=i.dot(nr);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var di=new K,kl=new xe,Gy=0,$e=class extends Jn{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Gy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=kg,this.updateRanges=[],this.gpuType=Wi,this.version=0,this._normalizationScale=t!==void 0?Vd(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)kl.fromBufferAttribute(this,e),kl.applyMatrix3(t),this.setXY(e,kl.x,kl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)di.fromBufferAttribute(this,e),di.applyMatrix3(t),this.setXYZ(e,di.x,di.y,di.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)di.fromBufferAttribute(this,e),di.applyMatrix4(t),this.setXYZ(e,di.x,di.y,di.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)di.fromBufferAttribute(this,e),di.applyNormalMatrix(t),this.setXYZ(e,di.x,di.y,di.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)di.fromBufferAttribute(this,e),di.transformDirection(t),this.setXYZ(e,di.x,di.y,di.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Iy(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Ly(t,this.array)}};var la=class extends $e{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ca=class extends $e{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Mn=class extends $e{constructor(t,e,i){super(new Float32Array(t),e,i)}},Wy=new Os,jo=new K,id=new K,ar=class{constructor(t=new K,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Wy.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;jo.subVectors(t,this.center);let e=jo.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(jo,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(id.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(jo.copy(t.center).add(id)),this.expandByPoint(jo.copy(t.center).sub(id))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Xy=0,vn=new Ue,nd=new an,no=new K,nn=new Os,Qo=new Os,Ti=new K,ii=class n extends Jn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Xy++}),this.uuid=Ta(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Ry(t)?ca:la)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Qt().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return vn.makeRotationFromQuaternion(t),this.applyMatrix4(vn),this}rotateX(t){return vn.makeRotationX(t),this.applyMatrix4(vn),this}rotateY(t){return vn.makeRotationY(t),this.applyMatrix4(vn),this}rotateZ(t){return vn.makeRotationZ(t),this.applyMatrix4(vn),this}translate(t,e,i){return vn.makeTranslation(t,e,i),this.applyMatrix4(vn),this}scale(t,e,i){return vn.makeScale(t,e,i),this.applyMatrix4(vn),this}lookAt(t){return nd.lookAt(t),nd.updateMatrix(),this.applyMatrix4(nd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(no).negate(),this.translate(no.x,no.y,no.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Mn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Yt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Os);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new K(-1/0,-1/0,-1/0),new K(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];nn.setFromBufferAttribute(r),this.morphTargetsRelative?(Ti.addVectors(this.boundingBox.min,nn.min),this.boundingBox.expandByPoint(Ti),Ti.addVectors(this.boundingBox.max,nn.max),this.boundingBox.expandByPoint(Ti)):(this.boundingBox.expandByPoint(nn.min),this.boundingBox.expandByPoint(nn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&jt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ar);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new K,1/0);return}if(t){let i=this.boundingSphere.center;if(nn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Qo.setFromBufferAttribute(a),this.morphTargetsRelative?(Ti.addVectors(nn.min,Qo.min),nn.expandByPoint(Ti),Ti.addVectors(nn.max,Qo.max),nn.expandByPoint(Ti)):(nn.expandByPoint(Qo.min),nn.expandByPoint(Qo.max))}nn.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Ti.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Ti));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)Ti.fromBufferAttribute(a,l),c&&(no.fromBufferAttribute(t,l),Ti.add(no)),s=Math.max(s,i.distanceToSquared(Ti))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&jt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){jt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new $e(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let k=0;k<i.count;k++)a[k]=new K,c[k]=new K;let h=new K,u=new K,d=new K,f=new xe,g=new xe,y=new xe,m=new K,p=new K;function v(k,N,I){l[k]=l[N]=l[I]=1,h.fromBufferAttribute(i,k),u.fromBufferAttribute(i,N),d.fromBufferAttribute(i,I),f.fromBufferAttribute(r,k),g.fromBufferAttribute(r,N),y.fromBufferAttribute(r,I),u.sub(h),d.sub(h),g.sub(f),y.sub(f);let V=1/(g.x*y.y-y.x*g.y);isFinite(V)&&(m.copy(u).multiplyScalar(y.y).addScaledVector(d,-g.y).multiplyScalar(V),p.copy(d).multiplyScalar(g.x).addScaledVector(u,-y.x).multiplyScalar(V),a[k].add(m),a[N].add(m),a[I].add(m),c[k].add(p),c[N].add(p),c[I].add(p))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let k=0,N=A.length;k<N;++k){let I=A[k],V=I.start,G=I.count;for(let D=V,H=V+G;D<H;D+=3)v(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let S=new K,C=new K,T=new K,x=new K;function E(k){T.fromBufferAttribute(s,k),x.copy(T);let N=a[k];S.copy(N),S.sub(T.multiplyScalar(T.dot(N))).normalize(),C.crossVectors(x,N);let V=C.dot(c[k])<0?-1:1;o.setXYZW(k,S.x,S.y,S.z,V)}for(let k=0,N=i.count;k<N;++k)l[k]&&E(k);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new $e(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new K,r=new K,o=new K,a=new K,c=new K,l=new K,h=new K,u=new K;if(t)for(let d=0,f=t.count;d<f;d+=3){let g=t.getX(d+0),y=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,y),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,g),c.fromBufferAttribute(i,y),l.fromBufferAttribute(i,m),a.add(h),c.add(h),l.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(y,c.x,c.y,c.z),i.setXYZ(m,l.x,l.y,l.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Ti.fromBufferAttribute(t,e),Ti.normalize(),t.setXYZ(e,Ti.x,Ti.y,Ti.z)}toNonIndexed(){function t(a,c){let l=a.array,h=a.itemSize,u=a.normalized,d=new l.constructor(c.length*h),f=0,g=0;for(let y=0,m=c.length;y<m;y++){a.isInterleavedBufferAttribute?f=c[y]*a.data.stride+a.offset:f=c[y]*h;for(let p=0;p<h;p++)d[g++]=l[f++]}return new $e(d,h,u)}if(this.index===null)return Yt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,i);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,u=l.length;h<u;h++){let d=l[h],f=t(d,i);c.push(f)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let c in i){let l=i[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let u=0,d=l.length;u<d;u++){let f=l[u];h.push(f.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],u=r[l];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,h=o.length;l<h;l++){let u=o[l];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var sd=new K,$y=new K,qy=new Qt,Dn=class{constructor(t=new K(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=sd.subVectors(i,e).cross($y.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(sd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||qy.getNormalMatrix(t),s=this.coplanarPoint(sd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Yy=0,ks=class extends Jn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Yy++}),this.uuid=Ta(),this.name="",this.type="Material",this.blending=_o,this.side=Hs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=xd,this.blendDst=vd,this.blendEquation=dr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new me(0,0,0),this.blendAlpha=0,this.depthFunc=lo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Lg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ec,this.stencilZFail=ec,this.stencilZPass=ec,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Yt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Yt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new me().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new Dn().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new xe().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new xe().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var fs=new K,rd=new K,Bl=new K,zl=new K,ha=class{constructor(t=new K,e=new K(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,fs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=fs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(fs.copy(this.origin).addScaledVector(this.direction,e),fs.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){rd.copy(t).add(e).multiplyScalar(.5),Bl.copy(e).sub(t).normalize(),zl.copy(this.origin).sub(rd);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Bl),a=zl.dot(this.direction),c=-zl.dot(Bl),l=zl.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*c-a,d=o*a-c,g=r*h,u>=0)if(d>=-g)if(d<=g){let y=1/h;u*=y,d*=y,f=u*(u+o*d+2*a)+d*(o*u+d+2*c)+l}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l):d<=g?(u=0,d=Math.min(Math.max(-r,-c),r),f=d*(d+2*c)+l):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(rd).addScaledVector(Bl,d),f}intersectSphere(t,e){if(t.radius<0)return null;fs.subVectors(t.center,this.origin);let i=fs.dot(this.direction),s=fs.dot(fs)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return l>=0?(i=(t.min.x-d.x)*l,s=(t.max.x-d.x)*l):(i=(t.max.x-d.x)*l,s=(t.min.x-d.x)*l),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,c=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,c=(t.min.z-d.z)*u),i>c||a>s)||((a>i||i!==i)&&(i=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,fs)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,g=e.x-o.x,y=e.y-o.y,m=e.z-o.z,p=i.x-o.x,v=i.y-o.y,A=i.z-o.z,S=Math.abs(c),C=Math.abs(l),T=Math.abs(h),x,E,k,N,I,V,G,D,H,Z,z,ct;if(S>=C&&S>=T?(k=c,V=u,H=g,ct=p,c>=0?(x=l,E=h,N=d,I=f,G=y,D=m,Z=v,z=A):(x=h,E=l,N=f,I=d,G=m,D=y,Z=A,z=v)):C>=T?(k=l,V=d,H=y,ct=v,l>=0?(x=h,E=c,N=f,I=u,G=m,D=g,Z=A,z=p):(x=c,E=h,N=u,I=f,G=g,D=m,Z=p,z=A)):(k=h,V=f,H=m,ct=A,h>=0?(x=c,E=l,N=u,I=d,G=g,D=y,Z=p,z=v):(x=l,E=c,N=d,I=u,G=y,D=g,Z=v,z=p)),k===0)return null;let J=x/k,Q=E/k,st=1/k,dt=N-J*V,ut=I-Q*V,tt=G-J*H,mt=D-Q*H,xt=Z-J*ct,At=z-Q*ct,St=xt*mt-At*tt,Gt=dt*At-ut*xt,ie=tt*ut-mt*dt;if(s){if(St<0||Gt<0||ie<0)return null}else if((St<0||Gt<0||ie<0)&&(St>0||Gt>0||ie>0))return null;let Vt=St+Gt+ie;if(Vt===0)return null;let le=st*(St*V+Gt*H+ie*ct);return(Vt>0?le<0:le>0)?null:this.at(le/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},gc=class extends ks{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new me(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Us,this.combine=yd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Zm=new Ue,sr=new ha,Vl=new ar,Jm=new K,Hl=new K,Gl=new K,Wl=new K,od=new K,Xl=new K,Km=new K,$l=new K,fi=class extends an{constructor(t=new ii,e=new gc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Xl.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],u=r[c];h!==0&&(od.fromBufferAttribute(u,t),o?Xl.addScaledVector(od,h):Xl.addScaledVector(od.sub(e),h))}e.add(Xl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Vl.copy(i.boundingSphere),Vl.applyMatrix4(r),sr.copy(t.ray).recast(t.near),!(Vl.containsPoint(sr.origin)===!1&&(sr.intersectSphere(Vl,Jm)===null||sr.origin.distanceToSquared(Jm)>(t.far-t.near)**2))&&(Zm.copy(r).invert(),sr.copy(t.ray).applyMatrix4(Zm),!(i.boundingBox!==null&&sr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,sr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let m=d[g],p=o[m.materialIndex],v=Math.max(m.start,f.start),A=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let S=v,C=A;S<C;S+=3){let T=a.getX(S),x=a.getX(S+1),E=a.getX(S+2);s=ql(this,p,t,i,l,h,u,T,x,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let m=g,p=y;m<p;m+=3){let v=a.getX(m),A=a.getX(m+1),S=a.getX(m+2);s=ql(this,o,t,i,l,h,u,v,A,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let m=d[g],p=o[m.materialIndex],v=Math.max(m.start,f.start),A=Math.min(c.count,Math.min(m.start+m.count,f.start+f.count));for(let S=v,C=A;S<C;S+=3){let T=S,x=S+1,E=S+2;s=ql(this,p,t,i,l,h,u,T,x,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(c.count,f.start+f.count);for(let m=g,p=y;m<p;m+=3){let v=m,A=m+1,S=m+2;s=ql(this,o,t,i,l,h,u,v,A,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Zy(n,t,e,i,s,r,o,a){let c;if(t.side===Gi?c=i.intersectTriangle(o,r,s,!0,a):c=i.intersectTriangle(s,r,o,t.side===Hs,a),c===null)return null;$l.copy(a),$l.applyMatrix4(n.matrixWorld);let l=e.ray.origin.distanceTo($l);return l<e.near||l>e.far?null:{distance:l,point:$l.clone(),object:n}}function ql(n,t,e,i,s,r,o,a,c,l){n.getVertexPosition(a,Hl),n.getVertexPosition(c,Gl),n.getVertexPosition(l,Wl);let h=Zy(n,t,e,i,Hl,Gl,Wl,Km);if(h){let u=new K;Ds.getBarycoord(Km,Hl,Gl,Wl,u),s&&(h.uv=Ds.getInterpolatedAttribute(s,a,c,l,u,new xe)),r&&(h.uv1=Ds.getInterpolatedAttribute(r,a,c,l,u,new xe)),o&&(h.normal=Ds.getInterpolatedAttribute(o,a,c,l,u,new K),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new K,materialIndex:0};Ds.getNormal(Hl,Gl,Wl,d.normal),h.face=d,h.barycoord=u}return h}var gs=class extends qi{constructor(t=null,e=1,i=1,s,r,o,a,c,l=Ai,h=Ai,u,d){super(null,o,a,c,l,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var rr=new ar,Jy=new xe(.5,.5),Yl=new K,lr=class{constructor(t=new Dn,e=new Dn,i=new Dn,s=new Dn,r=new Dn,o=new Dn){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=yn,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],y=r[9],m=r[10],p=r[11],v=r[12],A=r[13],S=r[14],C=r[15];if(s[0].setComponents(l-o,f-h,p-g,C-v).normalize(),s[1].setComponents(l+o,f+h,p+g,C+v).normalize(),s[2].setComponents(l+a,f+u,p+y,C+A).normalize(),s[3].setComponents(l-a,f-u,p-y,C-A).normalize(),i)s[4].setComponents(c,d,m,S).normalize(),s[5].setComponents(l-c,f-d,p-m,C-S).normalize();else if(s[4].setComponents(l-c,f-d,p-m,C-S).normalize(),e===yn)s[5].setComponents(l+c,f+d,p+m,C+S).normalize();else if(e===na)s[5].setComponents(c,d,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),rr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),rr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(rr)}intersectsSprite(t){rr.center.set(0,0,0);let e=Jy.distanceTo(t.center);return rr.radius=.7071067811865476+e,rr.applyMatrix4(t.matrixWorld),this.intersectsSphere(rr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Yl.x=s.normal.x>0?t.max.x:t.min.x,Yl.y=s.normal.y>0?t.max.y:t.min.y,Yl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Yl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},jm=new Ue,_c=class n{constructor(){this.coordinateSystem=yn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];jm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new lr),i[s].setFromProjectionMatrix(jm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new lr),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var xc=class extends ks{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new me(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Qm=new Ue,ud=new ha,Zl=new ar,Jl=new K,cr=class extends an{constructor(t=new ii,e=new xc){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Zl.copy(i.boundingSphere),Zl.applyMatrix4(s),Zl.radius+=r,t.ray.intersectsSphere(Zl)===!1)return;Qm.copy(s).invert(),ud.copy(t.ray).applyMatrix4(Qm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=i.index,u=i.attributes.position;if(l!==null){let d=Math.max(0,o.start),f=Math.min(l.count,o.start+o.count);for(let g=d,y=f;g<y;g++){let m=l.getX(g);Jl.fromBufferAttribute(u,m),tg(Jl,m,c,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let g=d,y=f;g<y;g++)Jl.fromBufferAttribute(u,g),tg(Jl,g,c,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function tg(n,t,e,i,s,r,o){let a=ud.distanceSqToPoint(n);if(a<e){let c=new K;ud.closestPointToPoint(n,c),c.applyMatrix4(i);let l=s.ray.origin.distanceTo(c);if(l<s.near||l>s.far)return;r.push({distance:l,distanceToRay:Math.sqrt(a),point:c,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var ua=class extends qi{constructor(t=[],e=fr,i,s,r,o,a,c,l,h){super(t,e,i,s,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var _s=class extends qi{constructor(t,e,i=Fn,s,r,o,a=Ai,c=Ai,l,h=ms,u=1){if(h!==ms&&h!==vs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,c,h,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ho(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},da=class extends _s{constructor(t,e=Fn,i=fr,s,r,o=Ai,a=Ai,c,l=ms){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,c,l),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},fa=class extends qi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},fo=class n extends ii{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(c),this.setAttribute("position",new Mn(l,3)),this.setAttribute("normal",new Mn(h,3)),this.setAttribute("uv",new Mn(u,2));function g(y,m,p,v,A,S,C,T,x,E,k){let N=S/x,I=C/E,V=S/2,G=C/2,D=T/2,H=x+1,Z=E+1,z=0,ct=0,J=new K;for(let Q=0;Q<Z;Q++){let st=Q*I-G;for(let dt=0;dt<H;dt++){let ut=dt*N-V;J[y]=ut*v,J[m]=st*A,J[p]=D,l.push(J.x,J.y,J.z),J[y]=0,J[m]=0,J[p]=T>0?1:-1,h.push(J.x,J.y,J.z),u.push(dt/x),u.push(1-Q/E),z+=1}}for(let Q=0;Q<E;Q++)for(let st=0;st<x;st++){let dt=d+st+H*Q,ut=d+st+H*(Q+1),tt=d+(st+1)+H*(Q+1),mt=d+(st+1)+H*Q;c.push(dt,ut,mt),c.push(ut,tt,mt),ct+=6}a.addGroup(f,ct,k),f+=ct,d+=z}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var pa=class n extends ii{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),c=Math.floor(s),l=a+1,h=c+1,u=t/a,d=e/c,f=[],g=[],y=[],m=[];for(let p=0;p<h;p++){let v=p*d-o;for(let A=0;A<l;A++){let S=A*u-r;g.push(S,-v,0),y.push(0,0,1),m.push(A/a),m.push(1-p/c)}}for(let p=0;p<c;p++)for(let v=0;v<a;v++){let A=v+l*p,S=v+l*(p+1),C=v+1+l*(p+1),T=v+1+l*p;f.push(A,S,T),f.push(S,C,T)}this.setIndex(f),this.setAttribute("position",new Mn(g,3)),this.setAttribute("normal",new Mn(y,3)),this.setAttribute("uv",new Mn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};function mr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(eg(s))s.isRenderTargetTexture?(Yt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(eg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Ui(n){let t={};for(let e=0;e<n.length;e++){let i=mr(n[e]);for(let s in i)t[s]=i[s]}return t}function eg(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Ky(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Hd(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:pe.workingColorSpace}var Xg={clone:mr,merge:Ui},jy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Qy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,jn=class extends ks{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=jy,this.fragmentShader=Qy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=mr(t.uniforms),this.uniformsGroups=Ky(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new me().setHex(s.value);break;case"v2":this.uniforms[i].value=new xe().fromArray(s.value);break;case"v3":this.uniforms[i].value=new K().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Ie().fromArray(s.value);break;case"m3":this.uniforms[i].value=new Qt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Ue().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},po=class extends jn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var vc=class extends ks{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Pg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},yc=class extends ks{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function so(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Kl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Bs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];i:{t:{let o;e:{n:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break n;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let c=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break i}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Mc=class extends Bs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ld,endingEnd:ld}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case cd:r=t,a=2*e-i;break;case hd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(c===void 0)switch(this.getSettings_().endingEnd){case cd:o=t,c=2*i-e;break;case hd:o=1,c=i+s[1]-s[0];break;default:o=t-1,c=e}let l=(i-e)*.5,h=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(i-e)/(s-e),y=g*g,m=y*g,p=-d*m+2*d*y-d*g,v=(1+d)*m+(-1.5-2*d)*y+(-.5+d)*g+1,A=(-1-f)*m+(1.5+f)*y+.5*g,S=f*m-f*y;for(let C=0;C!==a;++C)r[C]=p*o[h+C]+v*o[l+C]+A*o[c+C]+S*o[u+C];return r}},Sc=class extends Bs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=(i-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[l+d]*u+o[c+d]*h;return r}},bc=class extends Bs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},wc=class extends Bs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(i-e)/(s-e),y=1-g;for(let m=0;m!==a;++m)r[m]=o[l+m]*y+o[c+m]*g;return r}let d=a*2,f=t-1;for(let g=0;g!==a;++g){let y=o[l+g],m=o[c+g],p=f*d+g*2,v=u[p],A=u[p+1],S=t*d+g*2,C=h[S],T=h[S+1],x=eM(i,e,v,C,s);r[g]=$g(x,y,A,T,m)}return r}};function $g(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function tM(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function eM(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=$g(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let c=tM(r,t,e,i,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var ln=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=so(e,this.TimeBufferType),this.values=so(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:so(t.times,Array),values:so(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Kl(t.settings)&&(i.settings={inTangents:so(t.settings.inTangents,Array),outTangents:so(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new bc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Sc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Mc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new wc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ea:e=this.InterpolantFactoryMethodDiscrete;break;case uc:e=this.InterpolantFactoryMethodLinear;break;case tc:e=this.InterpolantFactoryMethodSmooth;break;case ad:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Yt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ea;case this.InterpolantFactoryMethodLinear:return uc;case this.InterpolantFactoryMethodSmooth:return tc;case this.InterpolantFactoryMethodBezier:return ad}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Kl(this.settings)&&(ig(this.settings.inTangents,t),ig(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Kl(this.settings)&&(ng(this.settings.inTangents,t),ng(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(jt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(jt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=i[a];if(typeof c=="number"&&isNaN(c)){jt("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){jt("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&Cy(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){jt("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===tc,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],h=t[a+1];if(l!==h&&(a!==1||l!==t[0]))if(s)c=!0;else{let u=a*i,d=u-i,f=u+i;for(let g=0;g!==i;++g){let y=e[u+g];if(y!==e[d+g]||y!==e[f+g]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let u=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,c=o*i,l=0;l!==i;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Kl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function ig(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function ng(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}ln.prototype.ValueTypeName="";ln.prototype.TimeBufferType=Float32Array;ln.prototype.ValueBufferType=Float32Array;ln.prototype.DefaultInterpolation=uc;var zs=class extends ln{constructor(t,e,i){super(t,e,i)}};zs.prototype.ValueTypeName="bool";zs.prototype.ValueBufferType=Array;zs.prototype.DefaultInterpolation=ea;zs.prototype.InterpolantFactoryMethodLinear=void 0;zs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ec=class extends ln{constructor(t,e,i,s){super(t,e,i,s)}};Ec.prototype.ValueTypeName="color";var Tc=class extends ln{constructor(t,e,i,s){super(t,e,i,s)}};Tc.prototype.ValueTypeName="number";var Ac=class extends Bs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(i-e)/(s-e),l=t*a;for(let h=l+a;l!==h;l+=4)Kn.slerpFlat(r,0,o,l-a,o,l,c);return r}},ma=class extends ln{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Ac(this.times,this.values,this.getValueSize(),t)}};ma.prototype.ValueTypeName="quaternion";ma.prototype.InterpolantFactoryMethodSmooth=void 0;var Vs=class extends ln{constructor(t,e,i){super(t,e,i)}};Vs.prototype.ValueTypeName="string";Vs.prototype.ValueBufferType=Array;Vs.prototype.DefaultInterpolation=ea;Vs.prototype.InterpolantFactoryMethodLinear=void 0;Vs.prototype.InterpolantFactoryMethodSmooth=void 0;var Rc=class extends ln{constructor(t,e,i,s){super(t,e,i,s)}};Rc.prototype.ValueTypeName="vector";var Cc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,u){return l.push(h,u),this},this.removeHandler=function(h){let u=l.indexOf(h);return u!==-1&&l.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=l.length;u<d;u+=2){let f=l[u],g=l[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},qg=new Cc,Pc=class{constructor(t){this.manager=t!==void 0?t:qg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Pc.DEFAULT_MATERIAL_NAME="__DEFAULT";var jl=new K,Ql=new Kn,Yn=new K,hr=class extends an{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ue,this.projectionMatrix=new Ue,this.projectionMatrixInverse=new Ue,this.coordinateSystem=yn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(jl,Ql,Yn),Yn.x===1&&Yn.y===1&&Yn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(jl,Ql,Yn.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(jl,Ql,Yn),Yn.x===1&&Yn.y===1&&Yn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(jl,Ql,Yn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ns=new K,sg=new xe,rg=new xe,rn=class extends hr{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=dc*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(zu*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return dc*2*Math.atan(Math.tan(zu*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Ns.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ns.x,Ns.y).multiplyScalar(-t/Ns.z),Ns.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ns.x,Ns.y).multiplyScalar(-t/Ns.z)}getViewSize(t,e){return this.getViewBounds(t,sg,rg),e.subVectors(rg,sg)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(zu*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*i/l,s*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ic=class extends hr{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var ro=-90,oo=1,mo=class extends an{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new rn(ro,oo,t,e);s.layers=this.layers,this.add(s);let r=new rn(ro,oo,t,e);r.layers=this.layers,this.add(r);let o=new rn(ro,oo,t,e);o.layers=this.layers,this.add(o);let a=new rn(ro,oo,t,e);a.layers=this.layers,this.add(a);let c=new rn(ro,oo,t,e);c.layers=this.layers,this.add(c);let l=new rn(ro,oo,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===yn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===na)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),i.texture.mipmapsAutoUpdate=y,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},Lc=class extends rn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Gd="\\[\\]\\.:\\/",iM=new RegExp("["+Gd+"]","g"),Wd="[^"+Gd+"]",nM="[^"+Gd.replace("\\.","")+"]",sM=/((?:WC+[\/:])*)/.source.replace("WC",Wd),rM=/(WCOD+)?/.source.replace("WCOD",nM),oM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Wd),aM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Wd),lM=new RegExp("^"+sM+rM+oM+aM+"$"),cM=["material","materials","bones","map"],dd=class{constructor(t,e,i){let s=i||He.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},He=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(iM,"")}static parseTrackName(t){let e=lM.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);cM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=i(a.children);if(c)return c}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Yt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let l=e.objectIndex;switch(i){case"materials":if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){jt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){jt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){jt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){jt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(l!==void 0){if(t[l]===void 0){jt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;jt("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};He.Composite=dd;He.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};He.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};He.prototype.GetterByBindingType=[He.prototype._getValue_direct,He.prototype._getValue_array,He.prototype._getValue_arrayElement,He.prototype._getValue_toArray];He.prototype.SetterByBindingTypeAndVersioning=[[He.prototype._setValue_direct,He.prototype._setValue_direct_setNeedsUpdate,He.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[He.prototype._setValue_array,He.prototype._setValue_array_setNeedsUpdate,He.prototype._setValue_array_setMatrixWorldNeedsUpdate],[He.prototype._setValue_arrayElement,He.prototype._setValue_arrayElement_setNeedsUpdate,He.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[He.prototype._setValue_fromArray,He.prototype._setValue_fromArray_setNeedsUpdate,He.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var gR=new Float32Array(1);var fd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};function Xd(n,t,e,i){let s=hM(i);switch(e){case Nd:return n*t;case Fd:return n*t/s.components*s.byteLength;case Bc:return n*t/s.components*s.byteLength;case Gs:return n*t*2/s.components*s.byteLength;case zc:return n*t*2/s.components*s.byteLength;case Dd:return n*t*3/s.components*s.byteLength;case Xi:return n*t*4/s.components*s.byteLength;case Vc:return n*t*4/s.components*s.byteLength;case xa:case va:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ya:case Ma:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Gc:case Xc:return Math.max(n,16)*Math.max(t,8)/4;case Hc:case Wc:return Math.max(n,8)*Math.max(t,8)/2;case $c:case qc:case Zc:case Jc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Yc:case Sa:case Kc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case jc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Qc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case th:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case eh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case ih:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case nh:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case sh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case rh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case oh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case ah:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case lh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case ch:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case hh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case uh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case dh:case fh:case ph:return Math.ceil(n/4)*Math.ceil(t/4)*16;case mh:case gh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case ba:case _h:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function hM(n){switch(n){case cn:case Cd:return{byteLength:1,components:1};case vo:case Pd:case Un:return{byteLength:2,components:1};case Oc:case kc:return{byteLength:2,components:4};case Fn:case Uc:case Wi:return{byteLength:4,components:1};case Id:case Ld:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Yt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function m0(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function dM(n){let t=new WeakMap;function e(a,c){let l=a.array,h=a.usage,u=l.byteLength,d=n.createBuffer();n.bindBuffer(c,d),n.bufferData(c,l,h),a.onUploadCallback();let f;if(l instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=n.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=n.SHORT;else if(l instanceof Uint32Array)f=n.UNSIGNED_INT;else if(l instanceof Int32Array)f=n.INT;else if(l instanceof Int8Array)f=n.BYTE;else if(l instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,c,l){let h=c.array,u=c.updateRanges;if(n.bindBuffer(l,a),u.length===0)n.bufferSubData(l,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],y=u[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,u[d]=y)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let y=u[f];n.bufferSubData(l,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(n.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var fM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,pM=`#ifdef USE_ALPHAHASH
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
#endif`,mM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,gM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,_M=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,xM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,vM=`#ifdef USE_AOMAP
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
#endif`,yM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,MM=`#ifdef USE_BATCHING
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
#endif`,SM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,bM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,wM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,EM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,TM=`#ifdef USE_IRIDESCENCE
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
#endif`,AM=`#ifdef USE_BUMPMAP
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
#endif`,RM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,CM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,PM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,IM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,LM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,NM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,DM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,FM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,UM=`#define PI 3.141592653589793
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
} // validated`,OM=`vec3 transformedNormal = objectNormal;
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
#endif`,kM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,BM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,zM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,VM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,HM="gl_FragColor = linearToOutputTexel( gl_FragColor );",GM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,WM=`#ifdef USE_ENVMAP
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
#endif`,XM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,$M=`#ifdef USE_ENVMAP
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
#endif`,qM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,YM=`#ifdef USE_ENVMAP
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
#endif`,ZM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,JM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,KM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,jM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,QM=`#ifdef USE_GRADIENTMAP
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
}`,tS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,eS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,iS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,nS=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,sS=`#ifdef USE_ENVMAP
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
#endif`,rS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,oS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,aS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,lS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,cS=`PhysicalMaterial material;
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
#endif`,hS=`uniform sampler2D dfgLUT;
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
}`,uS=`
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
#endif`,dS=`#if defined( RE_IndirectDiffuse )
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
#endif`,fS=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,pS=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,mS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,gS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,_S=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,xS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,vS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,yS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,MS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,SS=`#if defined( USE_POINTS_UV )
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
#endif`,bS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,wS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,ES=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,TS=`#if defined( USE_MORPHCOLORS )
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
#endif`,AS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,RS=`#ifdef USE_MORPHTARGETS
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
#endif`,CS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,PS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,IS=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,LS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,NS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,DS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,FS=`#ifdef USE_NORMALMAP
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
#endif`,US=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,OS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,kS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,BS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,zS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,VS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,HS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,GS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,WS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,XS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,$S=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,qS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,YS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,ZS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,JS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,KS=`float getShadowMask() {
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
}`,jS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,QS=`#ifdef USE_SKINNING
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
#endif`,tb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,eb=`#ifdef USE_SKINNING
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
#endif`,ib=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,nb=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,sb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,rb=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,ob=`#ifdef USE_TRANSMISSION
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
#endif`,ab=`#ifdef USE_TRANSMISSION
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
#endif`,lb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,cb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,hb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ub=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,db=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,fb=`uniform sampler2D t2D;
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
}`,pb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,mb=`uniform float backgroundBlurriness;
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
}`,gb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,_b=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,xb=`#include <common>
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
}`,vb=`#if DEPTH_PACKING == 3200
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
}`,yb=`#define DISTANCE
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
}`,Mb=`#define DISTANCE
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
}`,Sb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,bb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,wb=`uniform float scale;
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
}`,Eb=`uniform vec3 diffuse;
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
}`,Tb=`#include <common>
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
}`,Ab=`uniform vec3 diffuse;
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
}`,Rb=`#define LAMBERT
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
}`,Cb=`#define LAMBERT
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
}`,Pb=`#define MATCAP
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
}`,Ib=`#define MATCAP
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
}`,Lb=`#define NORMAL
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
}`,Nb=`#define NORMAL
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
}`,Db=`#define PHONG
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
}`,Fb=`#define PHONG
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
}`,Ub=`#define STANDARD
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
}`,Ob=`#define STANDARD
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
}`,kb=`#define TOON
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
}`,Bb=`#define TOON
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
}`,zb=`uniform float size;
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
}`,Vb=`uniform vec3 diffuse;
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
}`,Hb=`#include <common>
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
}`,Gb=`uniform vec3 color;
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
}`,Wb=`uniform float rotation;
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
}`,Xb=`uniform vec3 diffuse;
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
}`,ae={alphahash_fragment:fM,alphahash_pars_fragment:pM,alphamap_fragment:mM,alphamap_pars_fragment:gM,alphatest_fragment:_M,alphatest_pars_fragment:xM,aomap_fragment:vM,aomap_pars_fragment:yM,batching_pars_vertex:MM,batching_vertex:SM,begin_vertex:bM,beginnormal_vertex:wM,bsdfs:EM,iridescence_fragment:TM,bumpmap_pars_fragment:AM,clipping_planes_fragment:RM,clipping_planes_pars_fragment:CM,clipping_planes_pars_vertex:PM,clipping_planes_vertex:IM,color_fragment:LM,color_pars_fragment:NM,color_pars_vertex:DM,color_vertex:FM,common:UM,defaultnormal_vertex:OM,displacementmap_pars_vertex:kM,displacementmap_vertex:BM,emissivemap_fragment:zM,emissivemap_pars_fragment:VM,colorspace_fragment:HM,colorspace_pars_fragment:GM,envmap_fragment:WM,envmap_common_pars_fragment:XM,envmap_pars_fragment:$M,envmap_pars_vertex:qM,envmap_physical_pars_fragment:sS,envmap_vertex:YM,fog_vertex:ZM,fog_pars_vertex:JM,fog_fragment:KM,fog_pars_fragment:jM,gradientmap_pars_fragment:QM,lightmap_pars_fragment:tS,lights_lambert_fragment:eS,lights_lambert_pars_fragment:iS,lights_pars_begin:nS,lights_toon_fragment:rS,lights_toon_pars_fragment:oS,lights_phong_fragment:aS,lights_phong_pars_fragment:lS,lights_physical_fragment:cS,lights_physical_pars_fragment:hS,lights_fragment_begin:uS,lights_fragment_maps:dS,lights_fragment_end:fS,lightprobes_pars_fragment:pS,logdepthbuf_fragment:mS,logdepthbuf_pars_fragment:gS,logdepthbuf_pars_vertex:_S,logdepthbuf_vertex:xS,map_fragment:vS,map_pars_fragment:yS,map_particle_fragment:MS,map_particle_pars_fragment:SS,metalnessmap_fragment:bS,metalnessmap_pars_fragment:wS,morphinstance_vertex:ES,morphcolor_vertex:TS,morphnormal_vertex:AS,morphtarget_pars_vertex:RS,morphtarget_vertex:CS,normal_fragment_begin:PS,normal_fragment_maps:IS,normal_pars_fragment:LS,normal_pars_vertex:NS,normal_vertex:DS,normalmap_pars_fragment:FS,clearcoat_normal_fragment_begin:US,clearcoat_normal_fragment_maps:OS,clearcoat_pars_fragment:kS,iridescence_pars_fragment:BS,opaque_fragment:zS,packing:VS,premultiplied_alpha_fragment:HS,project_vertex:GS,dithering_fragment:WS,dithering_pars_fragment:XS,roughnessmap_fragment:$S,roughnessmap_pars_fragment:qS,shadowmap_pars_fragment:YS,shadowmap_pars_vertex:ZS,shadowmap_vertex:JS,shadowmask_pars_fragment:KS,skinbase_vertex:jS,skinning_pars_vertex:QS,skinning_vertex:tb,skinnormal_vertex:eb,specularmap_fragment:ib,specularmap_pars_fragment:nb,tonemapping_fragment:sb,tonemapping_pars_fragment:rb,transmission_fragment:ob,transmission_pars_fragment:ab,uv_pars_fragment:lb,uv_pars_vertex:cb,uv_vertex:hb,worldpos_vertex:ub,background_vert:db,background_frag:fb,backgroundCube_vert:pb,backgroundCube_frag:mb,cube_vert:gb,cube_frag:_b,depth_vert:xb,depth_frag:vb,distance_vert:yb,distance_frag:Mb,equirect_vert:Sb,equirect_frag:bb,linedashed_vert:wb,linedashed_frag:Eb,meshbasic_vert:Tb,meshbasic_frag:Ab,meshlambert_vert:Rb,meshlambert_frag:Cb,meshmatcap_vert:Pb,meshmatcap_frag:Ib,meshnormal_vert:Lb,meshnormal_frag:Nb,meshphong_vert:Db,meshphong_frag:Fb,meshphysical_vert:Ub,meshphysical_frag:Ob,meshtoon_vert:kb,meshtoon_frag:Bb,points_vert:zb,points_frag:Vb,shadow_vert:Hb,shadow_frag:Gb,sprite_vert:Wb,sprite_frag:Xb},Lt={common:{diffuse:{value:new me(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Qt},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Qt}},envmap:{envMap:{value:null},envMapRotation:{value:new Qt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Qt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Qt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Qt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Qt},normalScale:{value:new xe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Qt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Qt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Qt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Qt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new me(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new me(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0},uvTransform:{value:new Qt}},sprite:{diffuse:{value:new me(16777215)},opacity:{value:1},center:{value:new xe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Qt},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0}}},es={basic:{uniforms:Ui([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:ae.meshbasic_vert,fragmentShader:ae.meshbasic_frag},lambert:{uniforms:Ui([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new me(0)},envMapIntensity:{value:1}}]),vertexShader:ae.meshlambert_vert,fragmentShader:ae.meshlambert_frag},phong:{uniforms:Ui([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new me(0)},specular:{value:new me(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ae.meshphong_vert,fragmentShader:ae.meshphong_frag},standard:{uniforms:Ui([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new me(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ae.meshphysical_vert,fragmentShader:ae.meshphysical_frag},toon:{uniforms:Ui([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new me(0)}}]),vertexShader:ae.meshtoon_vert,fragmentShader:ae.meshtoon_frag},matcap:{uniforms:Ui([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:ae.meshmatcap_vert,fragmentShader:ae.meshmatcap_frag},points:{uniforms:Ui([Lt.points,Lt.fog]),vertexShader:ae.points_vert,fragmentShader:ae.points_frag},dashed:{uniforms:Ui([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ae.linedashed_vert,fragmentShader:ae.linedashed_frag},depth:{uniforms:Ui([Lt.common,Lt.displacementmap]),vertexShader:ae.depth_vert,fragmentShader:ae.depth_frag},normal:{uniforms:Ui([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:ae.meshnormal_vert,fragmentShader:ae.meshnormal_frag},sprite:{uniforms:Ui([Lt.sprite,Lt.fog]),vertexShader:ae.sprite_vert,fragmentShader:ae.sprite_frag},background:{uniforms:{uvTransform:{value:new Qt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ae.background_vert,fragmentShader:ae.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Qt}},vertexShader:ae.backgroundCube_vert,fragmentShader:ae.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ae.cube_vert,fragmentShader:ae.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ae.equirect_vert,fragmentShader:ae.equirect_frag},distance:{uniforms:Ui([Lt.common,Lt.displacementmap,{referencePosition:{value:new K},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ae.distance_vert,fragmentShader:ae.distance_frag},shadow:{uniforms:Ui([Lt.lights,Lt.fog,{color:{value:new me(0)},opacity:{value:1}}]),vertexShader:ae.shadow_vert,fragmentShader:ae.shadow_frag}};es.physical={uniforms:Ui([es.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Qt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Qt},clearcoatNormalScale:{value:new xe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Qt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Qt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Qt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Qt},sheen:{value:0},sheenColor:{value:new me(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Qt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Qt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Qt},transmissionSamplerSize:{value:new xe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Qt},attenuationDistance:{value:0},attenuationColor:{value:new me(0)},specularColor:{value:new me(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Qt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Qt},anisotropyVector:{value:new xe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Qt}}]),vertexShader:ae.meshphysical_vert,fragmentShader:ae.meshphysical_frag};var xh={r:0,b:0,g:0},$b=new Ue,g0=new Qt;g0.set(-1,0,0,0,1,0,0,0,1);function qb(n,t,e,i,s,r){let o=new me(0),a=s===!0?0:1,c,l,h=null,u=0,d=null;function f(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let S=v.backgroundBlurriness>0;A=t.get(A,S)}return A}function g(v){let A=!1,S=f(v);S===null?m(o,a):S&&S.isColor&&(m(S,1),A=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(v,A){let S=f(A);S&&S.isCubeTexture?(l===void 0&&(l=new fi(new fo(1,1,1),new jn({name:"BackgroundCubeMaterial",uniforms:mr(es.backgroundCube.uniforms),vertexShader:es.backgroundCube.vertexShader,fragmentShader:es.backgroundCube.fragmentShader,side:Gi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(C,T,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=S,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4($b.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(g0),l.material.toneMapped=pe.getTransfer(S.colorSpace)!==Ee,(h!==S||u!==S.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,h=S,u=S.version,d=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null)):S&&S.isTexture&&(c===void 0&&(c=new fi(new pa(2,2),new jn({name:"BackgroundMaterial",uniforms:mr(es.background.uniforms),vertexShader:es.background.vertexShader,fragmentShader:es.background.fragmentShader,side:Hs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=S,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=pe.getTransfer(S.colorSpace)!==Ee,S.matrixAutoUpdate===!0&&S.updateMatrix(),c.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||u!==S.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=S,u=S.version,d=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null))}function m(v,A){v.getRGB(xh,Hd(n)),e.buffers.color.setClear(xh.r,xh.g,xh.b,A,r)}function p(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:g,addToRenderList:y,dispose:p}}function Yb(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(I,V,G,D,H){let Z=!1,z=u(I,D,G,V);r!==z&&(r=z,l(r.object)),Z=f(I,D,G,H),Z&&g(I,D,G,H),H!==null&&t.update(H,n.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,S(I,V,G,D),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(H).buffer))}function c(){return n.createVertexArray()}function l(I){return n.bindVertexArray(I)}function h(I){return n.deleteVertexArray(I)}function u(I,V,G,D){let H=D.wireframe===!0,Z=i[V.id];Z===void 0&&(Z={},i[V.id]=Z);let z=I.isInstancedMesh===!0?I.id:0,ct=Z[z];ct===void 0&&(ct={},Z[z]=ct);let J=ct[G.id];J===void 0&&(J={},ct[G.id]=J);let Q=J[H];return Q===void 0&&(Q=d(c()),J[H]=Q),Q}function d(I){let V=[],G=[],D=[];for(let H=0;H<e;H++)V[H]=0,G[H]=0,D[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:V,enabledAttributes:G,attributeDivisors:D,object:I,attributes:{},index:null}}function f(I,V,G,D){let H=r.attributes,Z=V.attributes,z=0,ct=G.getAttributes();for(let J in ct)if(ct[J].location>=0){let st=H[J],dt=Z[J];if(dt===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(dt=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(dt=I.instanceColor)),st===void 0||st.attribute!==dt||dt&&st.data!==dt.data)return!0;z++}return r.attributesNum!==z||r.index!==D}function g(I,V,G,D){let H={},Z=V.attributes,z=0,ct=G.getAttributes();for(let J in ct)if(ct[J].location>=0){let st=Z[J];st===void 0&&(J==="instanceMatrix"&&I.instanceMatrix&&(st=I.instanceMatrix),J==="instanceColor"&&I.instanceColor&&(st=I.instanceColor));let dt={};dt.attribute=st,st&&st.data&&(dt.data=st.data),H[J]=dt,z++}r.attributes=H,r.attributesNum=z,r.index=D}function y(){let I=r.newAttributes;for(let V=0,G=I.length;V<G;V++)I[V]=0}function m(I){p(I,0)}function p(I,V){let G=r.newAttributes,D=r.enabledAttributes,H=r.attributeDivisors;G[I]=1,D[I]===0&&(n.enableVertexAttribArray(I),D[I]=1),H[I]!==V&&(n.vertexAttribDivisor(I,V),H[I]=V)}function v(){let I=r.newAttributes,V=r.enabledAttributes;for(let G=0,D=V.length;G<D;G++)V[G]!==I[G]&&(n.disableVertexAttribArray(G),V[G]=0)}function A(I,V,G,D,H,Z,z){z===!0?n.vertexAttribIPointer(I,V,G,H,Z):n.vertexAttribPointer(I,V,G,D,H,Z)}function S(I,V,G,D){y();let H=D.attributes,Z=G.getAttributes(),z=V.defaultAttributeValues;for(let ct in Z){let J=Z[ct];if(J.location>=0){let Q=H[ct];if(Q===void 0&&(ct==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),ct==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let st=Q.normalized,dt=Q.itemSize,ut=t.get(Q);if(ut===void 0)continue;let tt=ut.buffer,mt=ut.type,xt=ut.bytesPerElement,At=mt===n.INT||mt===n.UNSIGNED_INT||Q.gpuType===Uc;if(Q.isInterleavedBufferAttribute){let St=Q.data,Gt=St.isInterleavedBuffer===!0?St.stride:St.itemSize,ie=Q.offset;if(St.isInstancedInterleavedBuffer||St.isInstancedBufferAttribute){for(let Vt=0;Vt<J.locationSize;Vt++)p(J.location+Vt,St.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=St.meshPerAttribute*St.count)}else for(let Vt=0;Vt<J.locationSize;Vt++)m(J.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Vt=0;Vt<J.locationSize;Vt++)A(J.location+Vt,dt/J.locationSize,mt,st,Gt*xt,(ie+dt/J.locationSize*Vt)*xt,At)}else{if(Q.isInstancedBufferAttribute){for(let St=0;St<J.locationSize;St++)p(J.location+St,Q.meshPerAttribute);I.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let St=0;St<J.locationSize;St++)m(J.location+St);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let St=0;St<J.locationSize;St++)A(J.location+St,dt/J.locationSize,mt,st,dt*xt,dt/J.locationSize*St*xt,At)}}else if(z!==void 0){let st=z[ct];if(st!==void 0)switch(st.length){case 2:n.vertexAttrib2fv(J.location,st);break;case 3:n.vertexAttrib3fv(J.location,st);break;case 4:n.vertexAttrib4fv(J.location,st);break;default:n.vertexAttrib1fv(J.location,st)}}}}v()}function C(){k();for(let I in i){let V=i[I];for(let G in V){let D=V[G];for(let H in D){let Z=D[H];for(let z in Z)h(Z[z].object),delete Z[z];delete D[H]}}delete i[I]}}function T(I){if(i[I.id]===void 0)return;let V=i[I.id];for(let G in V){let D=V[G];for(let H in D){let Z=D[H];for(let z in Z)h(Z[z].object),delete Z[z];delete D[H]}}delete i[I.id]}function x(I){for(let V in i){let G=i[V];for(let D in G){let H=G[D];if(H[I.id]===void 0)continue;let Z=H[I.id];for(let z in Z)h(Z[z].object),delete Z[z];delete H[I.id]}}}function E(I){for(let V in i){let G=i[V],D=I.isInstancedMesh===!0?I.id:0,H=G[D];if(H!==void 0){for(let Z in H){let z=H[Z];for(let ct in z)h(z[ct].object),delete z[ct];delete H[Z]}delete G[D],Object.keys(G).length===0&&delete i[V]}}}function k(){N(),o=!0,r!==s&&(r=s,l(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:N,dispose:C,releaseStatesOfGeometry:T,releaseStatesOfObject:E,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:m,disableUnusedAttributes:v}}function Zb(n,t,e){let i;function s(c){i=c}function r(c,l){n.drawArrays(i,c,l),e.update(l,i,1)}function o(c,l,h){h!==0&&(n.drawArraysInstanced(i,c,l,h),e.update(l,i,h))}function a(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,h);let d=0;for(let f=0;f<h;f++)d+=l[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Jb(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Xi&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let E=x===Un&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==cn&&x!==Wi&&!E&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function c(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Yt("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Yt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Yt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:S,maxSamples:C,samples:T}}function Kb(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Dn,a=new Qt,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||i!==0||s;return s=d,i=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,y=u.clipIntersection,m=u.clipShadows,p=n.get(u);if(!s||g===null||g.length===0||r&&!m)r?h(null):l();else{let v=r?0:i,A=v*4,S=p.clippingState||null;c.value=S,S=h(g,d,A,f);for(let C=0;C!==A;++C)S[C]=e[C];p.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,d,f,g){let y=u!==null?u.length:0,m=null;if(y!==0){if(m=c.value,g!==!0||m===null){let p=f+y*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<p)&&(m=new Float32Array(p));for(let A=0,S=f;A!==y;++A,S+=4)o.copy(u[A]).applyMatrix4(v,a),o.normal.toArray(m,S),m[S+3]=o.constant}c.value=m,c.needsUpdate=!0}return t.numPlanes=y,t.numIntersection=0,m}}var Ca=class extends on{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new ua(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new fo(5,5,5),r=new jn({name:"CubemapFromEquirect",uniforms:mr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Gi,blending:ur});r.uniforms.tEquirect.value=e;let o=new fi(s,r),a=e.minFilter;return e.minFilter===xs&&(e.minFilter=Ri),new mo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Yg=256,jb=3,Qb=20,_0=256,x0=16,tw=3,ew=new K,iw=new me,yh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new mo(1,10,null),this._boxMesh=new fi(new fo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=ew}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=c.autoClear,d=c.autoClearColor,f=c.autoClearDepth,g=c.autoClearStencil,y=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,y===null&&(t.background=c.getClearColor(iw));let m=new mo(i,s,h);return m.position.copy(a),m.update(c,t),c.autoClear=u,c.autoClearColor=d,c.autoClearDepth=f,c.autoClearStencil=g,t.background=y,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Kg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Jg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Yg,Gg(t))}_fromTexture(t,e){t.mapping===fr||t.mapping===xo?this._setSize(t.image.length===0?Yg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Zg(t,!1,!1),i=Math.log2(t)-jb;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Zg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===fr||t.mapping===xo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Kg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Jg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=nw(),this._integrationMaterial=sw());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/x0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-tw)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(_0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=rw());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Zg(n,t,e){return new Ca(n,{minFilter:xs,generateMipmaps:t,type:Un,colorSpace:Fs,depthBuffer:e})}function Pa(n,t,e){return new jn({name:n,uniforms:t,vertexShader:ae.cube_vert,fragmentShader:e,side:Gi,blending:ur,depthTest:!1,depthWrite:!1})}function nw(){return Pa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${_0}u

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
	`)}function sw(){return Pa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:x0}},`

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
	`)}function rw(){return Pa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Qb}
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
	`)}function Jg(){return Pa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Kg(){return Pa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function ow(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Nc||f===Dc)if(t.has(d)){let g=t.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let y=new Ca(g.height);return y.fromEquirectangularTexture(n,d),t.set(d,y),d.addEventListener("dispose",l),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===Nc||f===Dc,y=f===fr||f===xo;if(g||y){let m=e.get(d),p=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==p)return i===null&&(i=new yh(n)),m=g?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let v=d.image;return g&&v&&v.height>0||y&&v&&c(v)?(i===null&&(i=new yh(n)),m=g?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===Nc?d.mapping=fr:f===Dc&&(d.mapping=xo),d}function c(d){let f=0,g=6;for(let y=0;y<g;y++)d[y]!==void 0&&f++;return f===g}function l(d){let f=d.target;f.removeEventListener("dispose",l);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function aw(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&ta("WebGLRenderer: "+i+" extension not supported."),s}}}function lw(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){c(g.target)}function c(g){g.index!==null&&t.remove(g.index);for(let m in g.attributes)t.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(t.remove(y),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function l(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),e.memory.geometries++),y}function h(g){let y=g.attributes;for(let m in y)t.update(y[m],n.ARRAY_BUFFER)}function u(g){let y=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let v=y!==null?y.array.length:m.array.length/3-1,A=m.count>=65535?ca:la,S=new A(Math.ceil(v/3)*6,1),C=S.array;if(y!==null){let x=y.array;p=y.version;for(let E=0,k=0;E<v;E+=3){let N=x[E+0],I=x[E+1],V=x[E+2];C[k++]=N,C[k++]=I,C[k++]=I,C[k++]=V,C[k++]=V,C[k++]=N}}else{p=m.version;for(let x=0,E=0;x<v;x+=3){let k=x+0,N=x+1,I=x+2;C[E++]=k,C[E++]=N,C[E++]=N,C[E++]=I,C[E++]=I,C[E++]=k}}S.version=p;let T=r.get(g);T&&t.remove(T),r.set(g,S)}function d(g){let y=r.get(g);if(y){let m=g.index;m!==null&&y.version<m.version&&u(g)}else u(g);return r.get(g)}function f(){for(let g in s){let y=s[g].deref();y!==void 0&&c(y)}}return{get:l,update:h,getWireframeAttribute:d,dispose:f}}function cw(n,t,e){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function c(u,d){n.drawElements(i,d,r,u*o),e.update(d,i,1)}function l(u,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,u*o,f),e.update(d,i,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,f);let y=0;for(let m=0;m<f;m++)y+=d[m];e.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function hw(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:jt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function uw(n,t,e){let i=new WeakMap,s=new Ie;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==u){let k=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",k)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;f===!0&&(A=1),g===!0&&(A=2),y===!0&&(A=3);let S=a.attributes.position.count*A,C=1;S>t.maxTextureSize&&(C=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let T=new Float32Array(S*C*4*u),x=new ra(T,S,C,u);x.type=Wi,x.needsUpdate=!0;let E=A*4;for(let N=0;N<u;N++){let I=m[N],V=p[N],G=v[N],D=S*C*4*N;for(let H=0;H<I.count;H++){let Z=H*E;f===!0&&(s.fromBufferAttribute(I,H),T[D+Z+0]=s.x,T[D+Z+1]=s.y,T[D+Z+2]=s.z,T[D+Z+3]=0),g===!0&&(s.fromBufferAttribute(V,H),T[D+Z+4]=s.x,T[D+Z+5]=s.y,T[D+Z+6]=s.z,T[D+Z+7]=0),y===!0&&(s.fromBufferAttribute(G,H),T[D+Z+8]=s.x,T[D+Z+9]=s.y,T[D+Z+10]=s.z,T[D+Z+11]=G.itemSize===4?s.w:1)}}d={count:u,texture:x,size:new xe(S,C)},i.set(a,d),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let y=0;y<l.length;y++)f+=l[y];let g=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(n,"morphTargetBaseInfluence",g),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function dw(n,t,e,i,s){let r=new WeakMap;function o(l){let h=s.render.frame,u=l.geometry,d=t.get(l,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var fw={[Md]:"LINEAR_TONE_MAPPING",[Sd]:"REINHARD_TONE_MAPPING",[bd]:"CINEON_TONE_MAPPING",[wd]:"ACES_FILMIC_TONE_MAPPING",[Td]:"AGX_TONE_MAPPING",[Ad]:"NEUTRAL_TONE_MAPPING",[Ed]:"CUSTOM_TONE_MAPPING"};function pw(n,t,e,i,s,r){let o=new on(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new ii;h.setAttribute("position",new Mn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Mn([0,2,0,0,2,0],2));let u=new po({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new fi(h,u),f=new Ic(-1,1,1,-1,0,1),g=null,y=null,m=!1,p,v=null,A=[],S=!1;this.setSize=function(C,T){o.setSize(C,T),a!==null&&a.setSize(C,T),c!==null&&c.setSize(C,T);for(let x=0;x<A.length;x++){let E=A[x];E.setSize&&E.setSize(C,T)}},this.setEffects=function(C){A=C,S=A.length>0&&A[0].isRenderPass===!0;let T=o.width,x=o.height;A.length>0&&a===null&&(a=new on(T,x,{type:Un,depthBuffer:!1,stencilBuffer:!1}),c=new on(T,x,{type:Un,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&A.some(k=>k.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&l===null&&(l=new _s(T,x),r===!0&&(l.format=vs,l.type=pr)),o.dispose(),o.depthTexture=E?l:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let k=0;k<A.length;k++){let N=A[k];N.setSize&&N.setSize(T,x),E&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(l)}},this.begin=function(C,T){if(m||C.toneMapping===Qn&&A.length===0)return!1;if(v=T,T!==null){let x=T.width,E=T.height;(o.width!==x||o.height!==E)&&this.setSize(x,E)}return S===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=Qn,!0},this.hasRenderPass=function(){return S},this.end=function(C,T){C.toneMapping=p,m=!0;let x=o,E=a;for(let k=0;k<A.length;k++){let N=A[k];N.enabled!==!1&&(N.render(C,E,x,T),N.needsSwap!==!1&&(x=E,E=E===a?c:a))}if(g!==C.outputColorSpace||y!==C.toneMapping){g=C.outputColorSpace,y=C.toneMapping,u.defines={},pe.getTransfer(g)===Ee&&(u.defines.SRGB_TRANSFER="");let k=fw[y];k&&(u.defines[k]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(v),C.render(d,f),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),u.dispose()}}var v0=new qi,y0=new _s(1,1),M0=new da(1),S0=new ra,b0=new mc,w0=new ua,jg=[],Qg=[],t0=new Float32Array(16),e0=new Float32Array(9),i0=new Float32Array(4);function Mo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=jg[s];if(r===void 0&&(r=new Float32Array(s),jg[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function vi(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function yi(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Sh(n,t){let e=Qg[t];e===void 0&&(e=new Int32Array(t),Qg[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function mw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function gw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vi(e,t))return;n.uniform2fv(this.addr,t),yi(e,t)}}function _w(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(vi(e,t))return;n.uniform3fv(this.addr,t),yi(e,t)}}function xw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vi(e,t))return;n.uniform4fv(this.addr,t),yi(e,t)}}function vw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(vi(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),yi(e,t)}else{if(vi(e,i))return;i0.set(i),n.uniformMatrix2fv(this.addr,!1,i0),yi(e,i)}}function yw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(vi(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),yi(e,t)}else{if(vi(e,i))return;e0.set(i),n.uniformMatrix3fv(this.addr,!1,e0),yi(e,i)}}function Mw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(vi(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),yi(e,t)}else{if(vi(e,i))return;t0.set(i),n.uniformMatrix4fv(this.addr,!1,t0),yi(e,i)}}function Sw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function bw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vi(e,t))return;n.uniform2iv(this.addr,t),yi(e,t)}}function ww(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vi(e,t))return;n.uniform3iv(this.addr,t),yi(e,t)}}function Ew(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vi(e,t))return;n.uniform4iv(this.addr,t),yi(e,t)}}function Tw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function Aw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vi(e,t))return;n.uniform2uiv(this.addr,t),yi(e,t)}}function Rw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vi(e,t))return;n.uniform3uiv(this.addr,t),yi(e,t)}}function Cw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vi(e,t))return;n.uniform4uiv(this.addr,t),yi(e,t)}}function bh(n){return n.version===0&&(n.compareFunction=Bd,n.needsUpdate=!0),n}function Pw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=bh(y0):r=v0,e.setTexture2D(t||r,s)}function Iw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||b0,s)}function Lw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=bh(M0):r=w0,e.setTextureCube(t||r,s)}function Nw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||S0,s)}function Dw(n){switch(n){case 5126:return mw;case 35664:return gw;case 35665:return _w;case 35666:return xw;case 35674:return vw;case 35675:return yw;case 35676:return Mw;case 5124:case 35670:return Sw;case 35667:case 35671:return bw;case 35668:case 35672:return ww;case 35669:case 35673:return Ew;case 5125:return Tw;case 36294:return Aw;case 36295:return Rw;case 36296:return Cw;case 35678:case 36198:case 36298:case 36306:case 35682:return Pw;case 35679:case 36299:case 36307:return Iw;case 35680:case 36300:case 36308:case 36293:return Lw;case 36289:case 36303:case 36311:case 36292:return Nw}}function Fw(n,t){n.uniform1fv(this.addr,t)}function Uw(n,t){let e=Mo(t,this.size,2);n.uniform2fv(this.addr,e)}function Ow(n,t){let e=Mo(t,this.size,3);n.uniform3fv(this.addr,e)}function kw(n,t){let e=Mo(t,this.size,4);n.uniform4fv(this.addr,e)}function Bw(n,t){let e=Mo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function zw(n,t){let e=Mo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function Vw(n,t){let e=Mo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Hw(n,t){n.uniform1iv(this.addr,t)}function Gw(n,t){n.uniform2iv(this.addr,t)}function Ww(n,t){n.uniform3iv(this.addr,t)}function Xw(n,t){n.uniform4iv(this.addr,t)}function $w(n,t){n.uniform1uiv(this.addr,t)}function qw(n,t){n.uniform2uiv(this.addr,t)}function Yw(n,t){n.uniform3uiv(this.addr,t)}function Zw(n,t){n.uniform4uiv(this.addr,t)}function Jw(n,t,e){let i=this.cache,s=t.length,r=Sh(e,s);vi(i,r)||(n.uniform1iv(this.addr,r),yi(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=bh(y0):o=v0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Kw(n,t,e){let i=this.cache,s=t.length,r=Sh(e,s);vi(i,r)||(n.uniform1iv(this.addr,r),yi(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||b0,r[o])}function jw(n,t,e){let i=this.cache,s=t.length,r=Sh(e,s);vi(i,r)||(n.uniform1iv(this.addr,r),yi(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=bh(M0):o=w0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function Qw(n,t,e){let i=this.cache,s=t.length,r=Sh(e,s);vi(i,r)||(n.uniform1iv(this.addr,r),yi(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||S0,r[o])}function t1(n){switch(n){case 5126:return Fw;case 35664:return Uw;case 35665:return Ow;case 35666:return kw;case 35674:return Bw;case 35675:return zw;case 35676:return Vw;case 5124:case 35670:return Hw;case 35667:case 35671:return Gw;case 35668:case 35672:return Ww;case 35669:case 35673:return Xw;case 5125:return $w;case 36294:return qw;case 36295:return Yw;case 36296:return Zw;case 35678:case 36198:case 36298:case 36306:case 35682:return Jw;case 35679:case 36299:case 36307:return Kw;case 35680:case 36300:case 36308:case 36293:return jw;case 36289:case 36303:case 36311:case 36292:return Qw}}var Yd=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=Dw(e.type)}},Zd=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=t1(e.type)}},Jd=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},$d=/(\w+)(\])?(\[|\.)?/g;function n0(n,t){n.seq.push(t),n.map[t.id]=t}function e1(n,t,e){let i=n.name,s=i.length;for($d.lastIndex=0;;){let r=$d.exec(i),o=$d.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){n0(e,l===void 0?new Yd(a,n,t):new Zd(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new Jd(a),n0(e,u)),e=u}}}var yo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);e1(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=i[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function s0(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var i1=37297,n1=0;function s1(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var r0=new Qt;function r1(n){pe._getMatrix(r0,pe.workingColorSpace,n);let t=`mat3( ${r0.elements.map(e=>e.toFixed(4))} )`;switch(pe.getTransfer(n)){case ia:return[t,"LinearTransferOETF"];case Ee:return[t,"sRGBTransferOETF"];default:return Yt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function o0(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+s1(n.getShaderSource(t),a)}else return r}function o1(n,t){let e=r1(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var a1={[Md]:"Linear",[Sd]:"Reinhard",[bd]:"Cineon",[wd]:"ACESFilmic",[Td]:"AgX",[Ad]:"Neutral",[Ed]:"Custom"};function l1(n,t){let e=a1[t];return e===void 0?(Yt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var vh=new K;function c1(){pe.getLuminanceCoefficients(vh);let n=vh.x.toFixed(4),t=vh.y.toFixed(4),e=vh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function h1(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ra).join(`
`)}function u1(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function d1(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Ra(n){return n!==""}function a0(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function l0(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var f1=/^[ \t]*#include +<([\w\d./]+)>/gm;function Kd(n){return n.replace(f1,p1)}function p1(n,t){let e=ae[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Kd(e)}var m1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function c0(n){return n.replace(m1,g1)}function g1(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function h0(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var _1={[ga]:"SHADOWMAP_TYPE_PCF",[go]:"SHADOWMAP_TYPE_VSM"};function x1(n){return _1[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var v1={[xo]:"ENVMAP_MODE_REFRACTION"};function y1(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":v1[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var M1={[yd]:"ENVMAP_BLENDING_MULTIPLY",[Ag]:"ENVMAP_BLENDING_MIX",[Rg]:"ENVMAP_BLENDING_ADD"};function S1(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":M1[n.combine]||"ENVMAP_BLENDING_NONE"}function b1(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=x1(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=y1(e),u=S1(e),d=h1(e),f=u1(r),g=s.createProgram(),y,m,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(y=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ra).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ra).join(`
`),m.length>0&&(m+=`
`)):(y=[h0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ra).join(`
`),m=[h0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Qn?"#define TONE_MAPPING":"",e.toneMapping!==Qn?ae.tonemapping_pars_fragment:"",e.toneMapping!==Qn?l1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ae.colorspace_pars_fragment,o1("linearToOutputTexel",e.outputColorSpace),c1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ra).join(`
`)),o=Kd(o),o=a0(o,e),o=l0(o,e),a=Kd(a),a=a0(a,e),a=l0(a,e),o=c0(o),a=c0(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",e.glslVersion===Ea?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Ea?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=p+y+o,A=p+m+a,S=s0(s,s.VERTEX_SHADER,v),C=s0(s,s.FRAGMENT_SHADER,A);s.attachShader(g,S),s.attachShader(g,C),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function T(N){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(g)||"",V=s.getShaderInfoLog(S)||"",G=s.getShaderInfoLog(C)||"",D=I.trim(),H=V.trim(),Z=G.trim(),z=!0,ct=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,S,C);else{let J=o0(s,S,"vertex"),Q=o0(s,C,"fragment");jt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+D+`
`+J+`
`+Q)}else D!==""?Yt("WebGLProgram: Program Info Log:",D):(H===""||Z==="")&&(ct=!1);ct&&(N.diagnostics={runnable:z,programLog:D,vertexShader:{log:H,prefix:y},fragmentShader:{log:Z,prefix:m}})}s.deleteShader(S),s.deleteShader(C),x=new yo(s,g),E=d1(s,g)}let x;this.getUniforms=function(){return x===void 0&&T(this),x};let E;this.getAttributes=function(){return E===void 0&&T(this),E};let k=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(g,i1)),k},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=n1++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=C,this}var w1=0,jd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Qd(t),e.set(t,i)),i}},Qd=class{constructor(t){this.id=w1++,this.code=t,this.usedTimes=0}};function E1(n){return n===Gs||n===Sa||n===ba}function T1(n,t,e,i,s,r){let o=new oa,a=new jd,c=new Set,l=[],h=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return c.add(x),x===0?"uv":`uv${x}`}function g(x,E,k,N,I,V){let G=N.fog,D=I.geometry,H=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?N.environment:null,Z=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,z=t.get(x.envMap||H,Z),ct=d[x.type],J=i.precision;x.precision!==null&&(J=i.getMaxPrecision(x.precision),J!==x.precision&&Yt("WebGLProgram.getParameters:",x.precision,"not supported, using",J,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,st=Q!==void 0?Q.length:0,dt=0;D.morphAttributes.position!==void 0&&(dt=1),D.morphAttributes.normal!==void 0&&(dt=2),D.morphAttributes.color!==void 0&&(dt=3);let ut,tt,mt,xt;if(ct){let Rt=es[ct];ut=Rt.vertexShader,tt=Rt.fragmentShader}else{ut=x.vertexShader,tt=x.fragmentShader;let Rt=a.getVertexShaderStage(x),se=a.getFragmentShaderStage(x);a.update(x,Rt,se),mt=Rt.id,xt=se.id}let At=n.getRenderTarget(),St=n.state.buffers.depth.getReversed(),Gt=I.isInstancedMesh===!0,ie=I.isBatchedMesh===!0,Vt=!!x.map,le=!!x.matcap,re=!!z,te=re&&z.isPMREMTexture===!0,Ge=!!x.aoMap,Fe=!!x.lightMap,ni=!!x.bumpMap&&x.wireframe===!1,Ce=!!x.normalMap,Mi=!!x.displacementMap,_e=!!x.emissiveMap,pi=!!x.metalnessMap,Ye=!!x.roughnessMap,si=x.anisotropy>0,U=x.clearcoat>0,Ct=x.diffuseRoughness>0,$t=x.dispersion>0,ne=x.retroreflectivity>0,bt=x.iridescence>0,Le=x.sheen>0,zt=x.transmission>0,Xt=si&&!!x.anisotropyMap,R=U&&!!x.clearcoatMap,M=U&&!!x.clearcoatNormalMap,W=U&&!!x.clearcoatRoughnessMap,ht=Ct&&!!x.diffuseRoughnessMap,ot=bt&&!!x.iridescenceMap,_t=bt&&!!x.iridescenceThicknessMap,vt=Le&&!!x.sheenColorMap,et=Le&&!!x.sheenRoughnessMap,nt=!!x.specularMap,pt=!!x.specularColorMap,F=!!x.specularIntensityMap,rt=zt&&!!x.transmissionMap,it=zt&&!!x.thicknessMap,wt=!!x.gradientMap,gt=!!x.alphaMap,Mt=x.alphaTest>0,Ht=!!x.alphaHash,Zt=!!x.extensions,lt=Qn;x.toneMapped&&(At===null||At.isXRRenderTarget===!0)&&(lt=n.toneMapping);let Ot=te?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,Jt={shaderID:ct,shaderType:x.type,shaderName:x.name,vertexShader:ut,fragmentShader:tt,defines:x.defines,customVertexShaderID:mt,customFragmentShaderID:xt,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:J,batching:ie,batchingColor:ie&&I._colorsTexture!==null,instancing:Gt,instancingColor:Gt&&I.instanceColor!==null,instancingMorph:Gt&&I.morphTexture!==null,outputColorSpace:At===null?n.outputColorSpace:At.isXRRenderTarget===!0?At.texture.colorSpace:pe.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Vt,matcap:le,envMap:re,envMapMode:re&&z.mapping,envMapPMREM:te,envMapMaxLod:te?Ot.length-1:null,envMapSize:te?Ot[0].width:null,aoMap:Ge,lightMap:Fe,bumpMap:ni,normalMap:Ce,displacementMap:Mi,emissiveMap:_e,normalMapObjectSpace:Ce&&x.normalMapType===Ig,normalMapTangentSpace:Ce&&x.normalMapType===Ud,packedNormalMap:Ce&&x.normalMapType===Ud&&E1(x.normalMap.format),metalnessMap:pi,roughnessMap:Ye,anisotropy:si,anisotropyMap:Xt,clearcoat:U,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:W,diffuseRoughness:Ct,diffuseRoughnessMap:ht,dispersion:$t,retroreflection:ne,iridescence:bt,iridescenceMap:ot,iridescenceThicknessMap:_t,sheen:Le,sheenColorMap:vt,sheenRoughnessMap:et,specularMap:nt,specularColorMap:pt,specularIntensityMap:F,transmission:zt,transmissionMap:rt,thicknessMap:it,gradientMap:wt,opaque:x.transparent===!1&&x.blending===_o&&x.alphaToCoverage===!1,alphaMap:gt,alphaTest:Mt,alphaHash:Ht,combine:x.combine,mapUv:Vt&&f(x.map.channel),aoMapUv:Ge&&f(x.aoMap.channel),lightMapUv:Fe&&f(x.lightMap.channel),bumpMapUv:ni&&f(x.bumpMap.channel),normalMapUv:Ce&&f(x.normalMap.channel),displacementMapUv:Mi&&f(x.displacementMap.channel),emissiveMapUv:_e&&f(x.emissiveMap.channel),metalnessMapUv:pi&&f(x.metalnessMap.channel),roughnessMapUv:Ye&&f(x.roughnessMap.channel),anisotropyMapUv:Xt&&f(x.anisotropyMap.channel),clearcoatMapUv:R&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:W&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ht&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:et&&f(x.sheenRoughnessMap.channel),specularMapUv:nt&&f(x.specularMap.channel),specularColorMapUv:pt&&f(x.specularColorMap.channel),specularIntensityMapUv:F&&f(x.specularIntensityMap.channel),transmissionMapUv:rt&&f(x.transmissionMap.channel),thicknessMapUv:it&&f(x.thicknessMap.channel),alphaMapUv:gt&&f(x.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Ce||si),vertexNormals:!!D.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!D.attributes.uv&&(Vt||gt),fog:!!G,useFog:x.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||D.attributes.normal===void 0&&Ce===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:St,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:st,morphTextureStride:dt,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:V.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&k.length>0,shadowMapType:n.shadowMap.type,toneMapping:lt,decodeVideoTexture:Vt&&x.map.isVideoTexture===!0&&pe.getTransfer(x.map.colorSpace)===Ee,decodeVideoTextureEmissive:_e&&x.emissiveMap.isVideoTexture===!0&&pe.getTransfer(x.emissiveMap.colorSpace)===Ee,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Sn,flipSided:x.side===Gi,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Zt&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Zt&&x.extensions.multiDraw===!0||ie)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Jt.vertexUv1s=c.has(1),Jt.vertexUv2s=c.has(2),Jt.vertexUv3s=c.has(3),c.clear(),Jt}function y(x){let E=[];if(x.shaderID?E.push(x.shaderID):(E.push(x.customVertexShaderID),E.push(x.customFragmentShaderID)),x.defines!==void 0)for(let k in x.defines)E.push(k),E.push(x.defines[k]);return x.isRawShaderMaterial===!1&&(m(E,x),p(E,x),E.push(n.outputColorSpace)),E.push(x.customProgramCacheKey),E.join()}function m(x,E){x.push(E.precision),x.push(E.outputColorSpace),x.push(E.envMapMode),x.push(E.envMapPMREM),x.push(E.envMapMaxLod),x.push(E.envMapSize),x.push(E.mapUv),x.push(E.alphaMapUv),x.push(E.lightMapUv),x.push(E.aoMapUv),x.push(E.bumpMapUv),x.push(E.normalMapUv),x.push(E.displacementMapUv),x.push(E.emissiveMapUv),x.push(E.metalnessMapUv),x.push(E.roughnessMapUv),x.push(E.anisotropyMapUv),x.push(E.clearcoatMapUv),x.push(E.clearcoatNormalMapUv),x.push(E.clearcoatRoughnessMapUv),x.push(E.diffuseRoughnessMapUv),x.push(E.iridescenceMapUv),x.push(E.iridescenceThicknessMapUv),x.push(E.sheenColorMapUv),x.push(E.sheenRoughnessMapUv),x.push(E.specularMapUv),x.push(E.specularColorMapUv),x.push(E.specularIntensityMapUv),x.push(E.transmissionMapUv),x.push(E.thicknessMapUv),x.push(E.combine),x.push(E.fogExp2),x.push(E.sizeAttenuation),x.push(E.morphTargetsCount),x.push(E.numSunLights),x.push(E.numDirLights),x.push(E.numPointLights),x.push(E.numSpotLights),x.push(E.numSpotLightMaps),x.push(E.numHemiLights),x.push(E.numRectAreaLights),x.push(E.numSunLightShadows),x.push(E.numDirLightShadows),x.push(E.numPointLightShadows),x.push(E.numSpotLightShadows),x.push(E.numSpotLightShadowsWithMaps),x.push(E.numLightProbes),x.push(E.numLightProbeGrids),x.push(E.shadowMapType),x.push(E.toneMapping),x.push(E.numClippingPlanes),x.push(E.numClipIntersection),x.push(E.depthPacking)}function p(x,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let E=d[x.type],k;if(E){let N=es[E];k=Xg.clone(N.uniforms)}else k=x.uniforms;return k}function A(x,E){let k=h.get(E);return k!==void 0?++k.usedTimes:(k=new b1(n,E,x,s),l.push(k),h.set(E,k)),k}function S(x){if(--x.usedTimes===0){let E=l.indexOf(x);l[E]=l[l.length-1],l.pop(),h.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function T(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:v,acquireProgram:A,releaseProgram:S,releaseShaderCache:C,programs:l,dispose:T}}function A1(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,c){n.get(o)[a]=c}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function R1(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function u0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function d0(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,y,m,p){let v=n[t];return v===void 0?(v={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:m,group:p},n[t]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=g,v.materialVariant=o(d),v.groupOrder=y,v.renderOrder=d.renderOrder,v.z=m,v.group=p),t++,v}function c(d,f,g,y,m,p,v){v.reversedDepth===!0&&(m=-m);let A=a(d,f,g,y,m,p);g.transmission>0?i.push(A):g.transparent===!0?s.push(A):e.push(A)}function l(d,f,g,y,m,p){let v=a(d,f,g,y,m,p);g.transmission>0?i.unshift(v):g.transparent===!0?s.unshift(v):e.unshift(v)}function h(d,f){e.length>1&&e.sort(d||R1),i.length>1&&i.sort(f||u0),s.length>1&&s.sort(f||u0)}function u(){for(let d=t,f=n.length;d<f;d++){let g=n[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:c,unshift:l,finish:u,sort:h}}function C1(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new d0,n.set(i,[o])):s>=r.length?(o=new d0,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function P1(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new K,color:new me};break;case"SpotLight":e={position:new K,direction:new K,color:new me,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new K,color:new me,distance:0,decay:0};break;case"HemisphereLight":e={direction:new K,skyColor:new me,groundColor:new me};break;case"RectAreaLight":e={color:new me,position:new K,halfWidth:new K,halfHeight:new K};break}return n[t.id]=e,e}}}function I1(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xe};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xe};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xe,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var L1=0;function N1(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function D1(n){let t=new P1,e=I1(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new K);let s=new K,r=new Ue,o=new Ue;function a(l){let h=0,u=0,d=0;for(let V=0;V<9;V++)i.probe[V].set(0,0,0);let f=0,g=0,y=0,m=0,p=0,v=0,A=0,S=0,C=0,T=0,x=0,E=0,k=0,N=0;l.sort(N1);for(let V=0,G=l.length;V<G;V++){let D=l[V],H=D.color,Z=D.intensity,z=D.distance,ct=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Gs?ct=D.shadow.map.texture:ct=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=H.r*Z,u+=H.g*Z,d+=H.b*Z;else if(D.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(D.sh.coefficients[J],Z);N++}else if(D.isSunLight){let J=t.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,st=e.get(D);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[g]=st,i.sunShadowMap[g]=ct;let dt=Q.getViewportCount();for(let ut=0;ut<dt;ut++)i.sunShadowMatrix[y+ut]=Q.getMatrix(ut),i.sunShadowCascade[y+ut]=Q._cascadeData[ut];y+=dt,g++}i.sun[f]=J,f++}else if(D.isDirectionalLight){let J=t.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,st=e.get(D);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,i.directionalShadow[m]=st,i.directionalShadowMap[m]=ct,i.directionalShadowMatrix[m]=D.shadow.matrix,C++}i.directional[m]=J,m++}else if(D.isSpotLight){let J=t.get(D);J.position.setFromMatrixPosition(D.matrixWorld),J.color.copy(H).multiplyScalar(Z),J.distance=z,J.coneCos=Math.cos(D.angle),J.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),J.decay=D.decay,i.spot[v]=J;let Q=D.shadow;if(D.map&&(i.spotLightMap[E]=D.map,E++,Q.updateMatrices(D),D.castShadow&&k++),i.spotLightMatrix[v]=Q.matrix,D.castShadow){let st=e.get(D);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,i.spotShadow[v]=st,i.spotShadowMap[v]=ct,x++}v++}else if(D.isRectAreaLight){let J=t.get(D);J.color.copy(H).multiplyScalar(Z),J.halfWidth.set(D.width*.5,0,0),J.halfHeight.set(0,D.height*.5,0),i.rectArea[A]=J,A++}else if(D.isPointLight){let J=t.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),J.distance=D.distance,J.decay=D.decay,D.castShadow){let Q=D.shadow,st=e.get(D);st.shadowIntensity=Q.intensity,st.shadowBias=Q.bias,st.shadowNormalBias=Q.normalBias,st.shadowRadius=Q.radius,st.shadowMapSize=Q.mapSize,st.shadowCameraNear=Q.camera.near,st.shadowCameraFar=Q.camera.far,i.pointShadow[p]=st,i.pointShadowMap[p]=ct,i.pointShadowMatrix[p]=D.shadow.matrix,T++}i.point[p]=J,p++}else if(D.isHemisphereLight){let J=t.get(D);J.skyColor.copy(D.color).multiplyScalar(Z),J.groundColor.copy(D.groundColor).multiplyScalar(Z),i.hemi[S]=J,S++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Lt.LTC_FLOAT_1,i.rectAreaLTC2=Lt.LTC_FLOAT_2):(i.rectAreaLTC1=Lt.LTC_HALF_1,i.rectAreaLTC2=Lt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let I=i.hash;(I.sunLength!==f||I.directionalLength!==m||I.pointLength!==p||I.spotLength!==v||I.rectAreaLength!==A||I.hemiLength!==S||I.numSunShadows!==g||I.numDirectionalShadows!==C||I.numPointShadows!==T||I.numSpotShadows!==x||I.numSpotMaps!==E||I.numLightProbes!==N)&&(i.sun.length=f,i.directional.length=m,i.spot.length=v,i.rectArea.length=A,i.point.length=p,i.hemi.length=S,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+E-k,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=k,i.numLightProbes=N,I.sunLength=f,I.directionalLength=m,I.pointLength=p,I.spotLength=v,I.rectAreaLength=A,I.hemiLength=S,I.numSunShadows=g,I.numDirectionalShadows=C,I.numPointShadows=T,I.numSpotShadows=x,I.numSpotMaps=E,I.numLightProbes=N,i.version=L1++)}function c(l,h){let u=0,d=0,f=0,g=0,y=0,m=0,p=h.matrixWorldInverse;for(let v=0,A=l.length;v<A;v++){let S=l[v];if(S.isSunLight){let C=i.sun[u];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(p),u++}else if(S.isDirectionalLight){let C=i.directional[d];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),d++}else if(S.isSpotLight){let C=i.spot[g];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),g++}else if(S.isRectAreaLight){let C=i.rectArea[y];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),o.identity(),r.copy(S.matrixWorld),r.premultiply(p),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),f++}else if(S.isHemisphereLight){let C=i.hemi[m];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(p),m++}}}return{setup:a,setupView:c,state:i}}function f0(n){let t=new D1(n),e=[],i=[],s=[];function r(u){h.camera=u,e.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){i.push(u)}function c(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function l(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function F1(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new f0(n),t.set(s,[a])):r>=o.length?(a=new f0(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var U1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,O1=`uniform sampler2D shadow_pass;
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
}`,k1=[new K(1,0,0),new K(-1,0,0),new K(0,1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1)],B1=[new K(0,-1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1),new K(0,-1,0),new K(0,-1,0)],p0=new Ue,Aa=new K,qd=new K;function z1(n,t,e){let i=new lr,s=new xe,r=new xe,o=new Ie,a=new vc,c=new yc,l={},h=e.maxTextureSize,u={[Hs]:Gi,[Gi]:Hs,[Sn]:Sn},d=new jn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new xe},radius:{value:4}},vertexShader:U1,fragmentShader:O1}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new ii;g.setAttribute("position",new $e(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new fi(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ga;let p=this.type;this.render=function(T,x,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||T.length===0)return;this.type===lg&&(Yt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ga);let k=n.getRenderTarget(),N=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),V=n.state;V.setBlending(ur),V.buffers.depth.getReversed()===!0?V.buffers.color.setClear(0,0,0,0):V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);let G=p!==this.type;G&&x.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(H=>H.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,H=T.length;D<H;D++){let Z=T[D],z=Z.shadow;if(z===void 0){Yt("WebGLShadowMap:",Z,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let ct=z.getFrameExtents();s.multiply(ct),r.copy(z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ct.x),s.x=r.x*ct.x,z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ct.y),s.y=r.y*ct.y,z.mapSize.y=r.y));let J=n.state.buffers.depth.getReversed();if(z.camera._reversedDepth=J,z.map===null||G===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===go){if(Z.isPointLight){Yt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new on(s.x,s.y,{format:Gs,type:Un,minFilter:Ri,magFilter:Ri,generateMipmaps:!1}),z.map.texture.name=Z.name+".shadowMap",z.map.depthTexture=new _s(s.x,s.y,Wi),z.map.depthTexture.name=Z.name+".shadowMapDepth",z.map.depthTexture.format=ms,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Ai,z.map.depthTexture.magFilter=Ai}else Z.isPointLight?(z.map=new Ca(s.x),z.map.depthTexture=new da(s.x,Fn)):(z.map=new on(s.x,s.y),z.map.depthTexture=new _s(s.x,s.y,Fn)),z.map.depthTexture.name=Z.name+".shadowMap",z.map.depthTexture.format=ms,this.type===ga?(z.map.depthTexture.compareFunction=J?kd:Od,z.map.depthTexture.minFilter=Ri,z.map.depthTexture.magFilter=Ri):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Ai,z.map.depthTexture.magFilter=Ai);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let Q=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();Z.isPointLight!==!0&&z.updateMatrices(Z,E);let st=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:E.layers;for(let dt=0;dt<Q;dt++){let ut=z.getCamera(dt);if(Z.isPointLight){let tt=z.camera,mt=z.matrix,xt=Z.distance||tt.far;xt!==tt.far&&(tt.far=xt,tt.updateProjectionMatrix()),Aa.setFromMatrixPosition(Z.matrixWorld),tt.position.copy(Aa),qd.copy(tt.position),qd.add(k1[dt]),tt.up.copy(B1[dt]),tt.lookAt(qd),tt.updateMatrixWorld(),mt.makeTranslation(-Aa.x,-Aa.y,-Aa.z),p0.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),z._frustum.setFromProjectionMatrix(p0,tt.coordinateSystem,tt.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)n.setRenderTarget(z.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(z.map),n.clear());let tt=z.getViewport(dt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),V.viewport(o)}i=z.getFrustum(dt),S(x,E,ut,Z,st,this.type)}z.isPointLightShadow!==!0&&this.type===go&&v(z,E),z.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(k,N,I)};function v(T,x){let E=t.update(y);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new on(s.x,s.y,{format:Gs,type:Un}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(x,null,E,d,y,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(x,null,E,f,y,null)}function A(T,x,E,k){let N=null,I=E.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(I!==void 0)N=I;else if(N=E.isPointLight===!0?c:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let V=N.uuid,G=x.uuid,D=l[V];D===void 0&&(D={},l[V]=D);let H=D[G];H===void 0&&(H=N.clone(),D[G]=H,x.addEventListener("dispose",C)),N=H}if(N.visible=x.visible,N.wireframe=x.wireframe,k===go?N.side=x.shadowSide!==null?x.shadowSide:x.side:N.side=x.shadowSide!==null?x.shadowSide:u[x.side],N.alphaMap=x.alphaMap,N.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,N.map=x.map,N.clipShadows=x.clipShadows,N.clippingPlanes=x.clippingPlanes,N.clipIntersection=x.clipIntersection,N.displacementMap=x.displacementMap,N.displacementScale=x.displacementScale,N.displacementBias=x.displacementBias,N.wireframeLinewidth=x.wireframeLinewidth,N.linewidth=x.linewidth,E.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let V=n.properties.get(N);V.light=E}return N}function S(T,x,E,k,N,I){if(T.visible===!1)return;if(T.layers.test(N)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&I===go)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,T.matrixWorld);let D=t.update(T),H=T.material;if(Array.isArray(H)){let Z=D.groups;for(let z=0,ct=Z.length;z<ct;z++){let J=Z[z],Q=H[J.materialIndex];if(Q&&Q.visible){let st=A(T,Q,k,I);T.onBeforeShadow(n,T,x,E,D,st,J),n.renderBufferDirect(E,null,D,st,T,J),T.onAfterShadow(n,T,x,E,D,st,J)}}}else if(H.visible){let Z=A(T,H,k,I);T.onBeforeShadow(n,T,x,E,D,Z,null),n.renderBufferDirect(E,null,D,Z,T,null),T.onAfterShadow(n,T,x,E,D,Z,null)}}let G=T.children;for(let D=0,H=G.length;D<H;D++)S(G[D],x,E,k,N,I)}function C(T){T.target.removeEventListener("dispose",C);for(let E in l){let k=l[E],N=T.target.uuid;N in k&&(k[N].dispose(),delete k[N])}}}function V1(n,t){function e(){let F=!1,rt=new Ie,it=null,wt=new Ie(0,0,0,0);return{setMask:function(gt){it!==gt&&!F&&(n.colorMask(gt,gt,gt,gt),it=gt)},setLocked:function(gt){F=gt},setClear:function(gt,Mt,Ht,Zt,lt){lt===!0&&(gt*=Zt,Mt*=Zt,Ht*=Zt),rt.set(gt,Mt,Ht,Zt),wt.equals(rt)===!1&&(n.clearColor(gt,Mt,Ht,Zt),wt.copy(rt))},reset:function(){F=!1,it=null,wt.set(-1,0,0,0)}}}function i(){let F=!1,rt=!1,it=null,wt=null,gt=null;return{setReversed:function(Mt){if(rt!==Mt){let Ht=t.get("EXT_clip_control");Mt?Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.ZERO_TO_ONE_EXT):Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.NEGATIVE_ONE_TO_ONE_EXT),rt=Mt;let Zt=gt;gt=null,this.setClear(Zt)}},getReversed:function(){return rt},setTest:function(Mt){Mt?St(n.DEPTH_TEST):Gt(n.DEPTH_TEST)},setMask:function(Mt){it!==Mt&&!F&&(n.depthMask(Mt),it=Mt)},setFunc:function(Mt){if(rt&&(Mt=Hg[Mt]),wt!==Mt){switch(Mt){case ic:n.depthFunc(n.NEVER);break;case nc:n.depthFunc(n.ALWAYS);break;case sc:n.depthFunc(n.LESS);break;case lo:n.depthFunc(n.LEQUAL);break;case rc:n.depthFunc(n.EQUAL);break;case oc:n.depthFunc(n.GEQUAL);break;case ac:n.depthFunc(n.GREATER);break;case lc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}wt=Mt}},setLocked:function(Mt){F=Mt},setClear:function(Mt){gt!==Mt&&(gt=Mt,rt&&(Mt=1-Mt),n.clearDepth(Mt))},reset:function(){F=!1,it=null,wt=null,gt=null,rt=!1}}}function s(){let F=!1,rt=null,it=null,wt=null,gt=null,Mt=null,Ht=null,Zt=null,lt=null;return{setTest:function(Ot){F||(Ot?St(n.STENCIL_TEST):Gt(n.STENCIL_TEST))},setMask:function(Ot){rt!==Ot&&!F&&(n.stencilMask(Ot),rt=Ot)},setFunc:function(Ot,Jt,Rt){(it!==Ot||wt!==Jt||gt!==Rt)&&(n.stencilFunc(Ot,Jt,Rt),it=Ot,wt=Jt,gt=Rt)},setOp:function(Ot,Jt,Rt){(Mt!==Ot||Ht!==Jt||Zt!==Rt)&&(n.stencilOp(Ot,Jt,Rt),Mt=Ot,Ht=Jt,Zt=Rt)},setLocked:function(Ot){F=Ot},setClear:function(Ot){lt!==Ot&&(n.clearStencil(Ot),lt=Ot)},reset:function(){F=!1,rt=null,it=null,wt=null,gt=null,Mt=null,Ht=null,Zt=null,lt=null}}}let r=new e,o=new i,a=new s,c={},l=new WeakMap,h={},u={},d={},f=new WeakMap,g=[],y=null,m=!1,p=null,v=null,A=null,S=null,C=null,T=null,x=null,E=new me(0,0,0),k=0,N=!1,I=null,V=null,G=null,D=null,H=null,Z=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,ct=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(ct=parseFloat(/^WebGL (\d)/.exec(J)[1]),z=ct>=1):J.indexOf("OpenGL ES")!==-1&&(ct=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),z=ct>=2);let Q=null,st={},dt=n.getParameter(n.SCISSOR_BOX),ut=n.getParameter(n.VIEWPORT),tt=new Ie().fromArray(dt),mt=new Ie().fromArray(ut);function xt(F,rt,it,wt){let gt=new Uint8Array(4),Mt=n.createTexture();n.bindTexture(F,Mt),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ht=0;Ht<it;Ht++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,wt,0,n.RGBA,n.UNSIGNED_BYTE,gt):n.texImage2D(rt+Ht,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,gt);return Mt}let At={};At[n.TEXTURE_2D]=xt(n.TEXTURE_2D,n.TEXTURE_2D,1),At[n.TEXTURE_CUBE_MAP]=xt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),At[n.TEXTURE_2D_ARRAY]=xt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),At[n.TEXTURE_3D]=xt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),St(n.DEPTH_TEST),o.setFunc(lo),ni(!1),Ce(pd),St(n.CULL_FACE),Ge(ur);function St(F){h[F]!==!0&&(n.enable(F),h[F]=!0)}function Gt(F){h[F]!==!1&&(n.disable(F),h[F]=!1)}function ie(F,rt){return d[F]!==rt?(n.bindFramebuffer(F,rt),d[F]=rt,F===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=rt),F===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(F,rt){let it=g,wt=!1;if(F){it=f.get(rt),it===void 0&&(it=[],f.set(rt,it));let gt=F.textures;if(it.length!==gt.length||it[0]!==n.COLOR_ATTACHMENT0){for(let Mt=0,Ht=gt.length;Mt<Ht;Mt++)it[Mt]=n.COLOR_ATTACHMENT0+Mt;it.length=gt.length,wt=!0}}else it[0]!==n.BACK&&(it[0]=n.BACK,wt=!0);wt&&n.drawBuffers(it)}function le(F){return y!==F?(n.useProgram(F),y=F,!0):!1}let re={[dr]:n.FUNC_ADD,[hg]:n.FUNC_SUBTRACT,[ug]:n.FUNC_REVERSE_SUBTRACT};re[dg]=n.MIN,re[fg]=n.MAX;let te={[pg]:n.ZERO,[mg]:n.ONE,[gg]:n.SRC_COLOR,[xd]:n.SRC_ALPHA,[Sg]:n.SRC_ALPHA_SATURATE,[yg]:n.DST_COLOR,[xg]:n.DST_ALPHA,[_g]:n.ONE_MINUS_SRC_COLOR,[vd]:n.ONE_MINUS_SRC_ALPHA,[Mg]:n.ONE_MINUS_DST_COLOR,[vg]:n.ONE_MINUS_DST_ALPHA,[bg]:n.CONSTANT_COLOR,[wg]:n.ONE_MINUS_CONSTANT_COLOR,[Eg]:n.CONSTANT_ALPHA,[Tg]:n.ONE_MINUS_CONSTANT_ALPHA};function Ge(F,rt,it,wt,gt,Mt,Ht,Zt,lt,Ot){if(F===ur){m===!0&&(Gt(n.BLEND),m=!1);return}if(m===!1&&(St(n.BLEND),m=!0),F!==cg){if(F!==p||Ot!==N){if((v!==dr||C!==dr)&&(n.blendEquation(n.FUNC_ADD),v=dr,C=dr),Ot)switch(F){case _o:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case md:n.blendFunc(n.ONE,n.ONE);break;case gd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case _d:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:jt("WebGLState: Invalid blending: ",F);break}else switch(F){case _o:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case md:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case gd:jt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case _d:jt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:jt("WebGLState: Invalid blending: ",F);break}A=null,S=null,T=null,x=null,E.set(0,0,0),k=0,p=F,N=Ot}return}gt=gt||rt,Mt=Mt||it,Ht=Ht||wt,(rt!==v||gt!==C)&&(n.blendEquationSeparate(re[rt],re[gt]),v=rt,C=gt),(it!==A||wt!==S||Mt!==T||Ht!==x)&&(n.blendFuncSeparate(te[it],te[wt],te[Mt],te[Ht]),A=it,S=wt,T=Mt,x=Ht),(Zt.equals(E)===!1||lt!==k)&&(n.blendColor(Zt.r,Zt.g,Zt.b,lt),E.copy(Zt),k=lt),p=F,N=!1}function Fe(F,rt){F.side===Sn?Gt(n.CULL_FACE):St(n.CULL_FACE);let it=F.side===Gi;rt&&(it=!it),ni(it),F.blending===_o&&F.transparent===!1?Ge(ur):Ge(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let wt=F.stencilWrite;a.setTest(wt),wt&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),_e(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?St(n.SAMPLE_ALPHA_TO_COVERAGE):Gt(n.SAMPLE_ALPHA_TO_COVERAGE)}function ni(F){I!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),I=F)}function Ce(F){F!==og?(St(n.CULL_FACE),F!==V&&(F===pd?n.cullFace(n.BACK):F===ag?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Gt(n.CULL_FACE),V=F}function Mi(F){F!==G&&(z&&n.lineWidth(F),G=F)}function _e(F,rt,it){F?(St(n.POLYGON_OFFSET_FILL),(D!==rt||H!==it)&&(D=rt,H=it,o.getReversed()&&(rt=-rt,it=-it),n.polygonOffset(rt,it))):Gt(n.POLYGON_OFFSET_FILL)}function pi(F){F?St(n.SCISSOR_TEST):Gt(n.SCISSOR_TEST)}function Ye(F){F===void 0&&(F=n.TEXTURE0+Z-1),Q!==F&&(n.activeTexture(F),Q=F)}function si(F,rt,it){it===void 0&&(Q===null?it=n.TEXTURE0+Z-1:it=Q);let wt=st[it];wt===void 0&&(wt={type:void 0,texture:void 0},st[it]=wt),(wt.type!==F||wt.texture!==rt)&&(Q!==it&&(n.activeTexture(it),Q=it),n.bindTexture(F,rt||At[F]),wt.type=F,wt.texture=rt)}function U(){let F=st[Q];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Ct(){try{n.compressedTexImage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function $t(){try{n.compressedTexImage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function ne(){try{n.texSubImage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function bt(){try{n.texSubImage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function Le(){try{n.compressedTexSubImage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function zt(){try{n.compressedTexSubImage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function Xt(){try{n.texStorage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function M(){try{n.texImage2D(...arguments)}catch(F){jt("WebGLState:",F)}}function W(){try{n.texImage3D(...arguments)}catch(F){jt("WebGLState:",F)}}function ht(F){return u[F]!==void 0?u[F]:n.getParameter(F)}function ot(F,rt){u[F]!==rt&&(n.pixelStorei(F,rt),u[F]=rt)}function _t(F){tt.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),tt.copy(F))}function vt(F){mt.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),mt.copy(F))}function et(F,rt){let it=l.get(rt);it===void 0&&(it=new WeakMap,l.set(rt,it));let wt=it.get(F);wt===void 0&&(wt=n.getUniformBlockIndex(rt,F.name),n.uniformBlockBinding(rt,wt,wt),it.set(F,wt))}function nt(F,rt,it){let gt=l.get(rt).get(F);c[gt]!==it&&(n.bindBufferBase(n.UNIFORM_BUFFER,gt,it),c[gt]=it)}function pt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,st={},d={},c={},f=new WeakMap,g=[],y=null,m=!1,p=null,v=null,A=null,S=null,C=null,T=null,x=null,E=new me(0,0,0),k=0,N=!1,I=null,V=null,G=null,D=null,H=null,tt.set(0,0,n.canvas.width,n.canvas.height),mt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:St,disable:Gt,bindFramebuffer:ie,drawBuffers:Vt,useProgram:le,setBlending:Ge,setMaterial:Fe,setFlipSided:ni,setCullFace:Ce,setLineWidth:Mi,setPolygonOffset:_e,setScissorTest:pi,activeTexture:Ye,bindTexture:si,unbindTexture:U,compressedTexImage2D:Ct,compressedTexImage3D:$t,texImage2D:M,texImage3D:W,pixelStorei:ot,getParameter:ht,updateUBOMapping:et,uniformBlockBinding:nt,texStorage2D:Xt,texStorage3D:R,texSubImage2D:ne,texSubImage3D:bt,compressedTexSubImage2D:Le,compressedTexSubImage3D:zt,scissor:_t,viewport:vt,reset:pt}}function H1(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new xe,h=new WeakMap,u=new Set,d,f=new WeakMap,g=new Set,y=new FinalizationRegistry(R=>g.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(R,M){return m?new OffscreenCanvas(R,M):sa("canvas")}function v(R,M,W){let ht=1,ot=Xt(R);if((ot.width>W||ot.height>W)&&(ht=W/Math.max(ot.width,ot.height)),ht<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let _t=Math.floor(ht*ot.width),vt=Math.floor(ht*ot.height);d===void 0&&(d=p(_t,vt));let et=M?p(_t,vt):d;return et.width=_t,et.height=vt,et.getContext("2d").drawImage(R,0,0,_t,vt),Yt("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+_t+"x"+vt+")."),et}else return"data"in R&&Yt("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),R;return R}function A(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(R,M,W,ht,ot,_t=!1){if(R!==null){if(n[R]!==void 0)return n[R];Yt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let vt;ht&&(vt=t.get("EXT_texture_norm16"),vt||Yt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=M;if(M===n.RED&&(W===n.FLOAT&&(et=n.R32F),W===n.HALF_FLOAT&&(et=n.R16F),W===n.UNSIGNED_BYTE&&(et=n.R8),W===n.UNSIGNED_SHORT&&vt&&(et=vt.R16_EXT),W===n.SHORT&&vt&&(et=vt.R16_SNORM_EXT)),M===n.RED_INTEGER&&(W===n.UNSIGNED_BYTE&&(et=n.R8UI),W===n.UNSIGNED_SHORT&&(et=n.R16UI),W===n.UNSIGNED_INT&&(et=n.R32UI),W===n.BYTE&&(et=n.R8I),W===n.SHORT&&(et=n.R16I),W===n.INT&&(et=n.R32I)),M===n.RG&&(W===n.FLOAT&&(et=n.RG32F),W===n.HALF_FLOAT&&(et=n.RG16F),W===n.UNSIGNED_BYTE&&(et=n.RG8),W===n.UNSIGNED_SHORT&&vt&&(et=vt.RG16_EXT),W===n.SHORT&&vt&&(et=vt.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(W===n.UNSIGNED_BYTE&&(et=n.RG8UI),W===n.UNSIGNED_SHORT&&(et=n.RG16UI),W===n.UNSIGNED_INT&&(et=n.RG32UI),W===n.BYTE&&(et=n.RG8I),W===n.SHORT&&(et=n.RG16I),W===n.INT&&(et=n.RG32I)),M===n.RGB_INTEGER&&(W===n.UNSIGNED_BYTE&&(et=n.RGB8UI),W===n.UNSIGNED_SHORT&&(et=n.RGB16UI),W===n.UNSIGNED_INT&&(et=n.RGB32UI),W===n.BYTE&&(et=n.RGB8I),W===n.SHORT&&(et=n.RGB16I),W===n.INT&&(et=n.RGB32I)),M===n.RGBA_INTEGER&&(W===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),W===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),W===n.UNSIGNED_INT&&(et=n.RGBA32UI),W===n.BYTE&&(et=n.RGBA8I),W===n.SHORT&&(et=n.RGBA16I),W===n.INT&&(et=n.RGBA32I)),M===n.RGB&&(W===n.UNSIGNED_SHORT&&vt&&(et=vt.RGB16_EXT),W===n.SHORT&&vt&&(et=vt.RGB16_SNORM_EXT),W===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),W===n.UNSIGNED_INT_10F_11F_11F_REV&&(et=n.R11F_G11F_B10F)),M===n.RGBA){let nt=_t?ia:pe.getTransfer(ot);W===n.FLOAT&&(et=n.RGBA32F),W===n.HALF_FLOAT&&(et=n.RGBA16F),W===n.UNSIGNED_BYTE&&(et=nt===Ee?n.SRGB8_ALPHA8:n.RGBA8),W===n.UNSIGNED_SHORT&&vt&&(et=vt.RGBA16_EXT),W===n.SHORT&&vt&&(et=vt.RGBA16_SNORM_EXT),W===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),W===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function x(R,M){let W;return R?M===null||M===Fn||M===pr?W=n.DEPTH24_STENCIL8:M===Wi?W=n.DEPTH32F_STENCIL8:M===vo&&(W=n.DEPTH24_STENCIL8,Yt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Fn||M===pr?W=n.DEPTH_COMPONENT24:M===Wi?W=n.DEPTH_COMPONENT32F:M===vo&&(W=n.DEPTH_COMPONENT16),W}function E(R,M){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==Ai&&R.minFilter!==Ri?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function k(R){let M=new WeakRef(R);i.get(R).__ref=M,g.add(M),y.register(R,M,M)}function N(R){let M=i.get(R).__ref;M!==void 0&&(g.delete(M),y.unregister(M))}function I(R){G(R.target)}function V(R){D(R.target)}function G(R){R.removeEventListener("dispose",I),N(R),Z(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function D(R){R.removeEventListener("dispose",V),N(R),ct(R)}function H(){for(let R of g){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?D(M):G(M))}g.clear(),u.clear()}function Z(R){let M=i.get(R);if(M.__webglInit===void 0)return;let W=R.source,ht=f.get(W);if(ht){let ot=ht[M.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&z(R),Object.keys(ht).length===0&&f.delete(W)}i.remove(R)}function z(R){let M=i.get(R);n.deleteTexture(M.__webglTexture);let W=R.source,ht=f.get(W);delete ht[M.__cacheKey],o.memory.textures--}function ct(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let W=R.depthTexture;if(W&&W.renderTarget===R&&G(W),R.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(M.__webglFramebuffer[ot]))for(let _t=0;_t<M.__webglFramebuffer[ot].length;_t++)n.deleteFramebuffer(M.__webglFramebuffer[ot][_t]);else n.deleteFramebuffer(M.__webglFramebuffer[ot]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[ot])}else{if(Array.isArray(M.__webglFramebuffer))for(let ot=0;ot<M.__webglFramebuffer.length;ot++)n.deleteFramebuffer(M.__webglFramebuffer[ot]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let ot=0;ot<M.__webglColorRenderbuffer.length;ot++)M.__webglColorRenderbuffer[ot]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[ot]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ht=R.textures;for(let ot=0,_t=ht.length;ot<_t;ot++){let vt=i.get(ht[ot]);vt.__webglTexture&&(n.deleteTexture(vt.__webglTexture),o.memory.textures--),i.remove(ht[ot])}i.remove(R)}let J=0;function Q(){J=0}function st(){return J}function dt(R){J=R}function ut(){let R=J;return R>=s.maxTextures&&Yt("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,R}function tt(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function mt(R,M){let W=i.get(R);if(R.isVideoTexture&&Le(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&W.__version!==R.version){let ht=R.image;if(ht===null)Yt("WebGLRenderer: Texture marked for update but no image data found.");else if(ht.complete===!1)Yt("WebGLRenderer: Texture marked for update but image is incomplete");else{Fe(W,R,M);return}}else R.isExternalTexture&&(W.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,W.__webglTexture,n.TEXTURE0+M)}function xt(R,M){let W=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&W.__version!==R.version){Fe(W,R,M);return}else R.isExternalTexture&&(W.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,W.__webglTexture,n.TEXTURE0+M)}function At(R,M){let W=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&W.__version!==R.version){Fe(W,R,M);return}e.bindTexture(n.TEXTURE_3D,W.__webglTexture,n.TEXTURE0+M)}function St(R,M){let W=i.get(R);if(R.version>0&&W.__version!==R.version){ni(W,R,M);return}e.bindTexture(n.TEXTURE_CUBE_MAP,W.__webglTexture,n.TEXTURE0+M)}let Gt={[cc]:n.REPEAT,[Zn]:n.CLAMP_TO_EDGE,[hc]:n.MIRRORED_REPEAT},ie={[Ai]:n.NEAREST,[Cg]:n.NEAREST_MIPMAP_NEAREST,[_a]:n.NEAREST_MIPMAP_LINEAR,[Ri]:n.LINEAR,[Fc]:n.LINEAR_MIPMAP_NEAREST,[xs]:n.LINEAR_MIPMAP_LINEAR},Vt={[Ng]:n.NEVER,[Bd]:n.ALWAYS,[Dg]:n.LESS,[Od]:n.LEQUAL,[Fg]:n.EQUAL,[kd]:n.GEQUAL,[Ug]:n.GREATER,[Og]:n.NOTEQUAL};function le(R,M){if(M.type===Wi&&t.has("OES_texture_float_linear")===!1&&(M.magFilter===Ri||M.magFilter===Fc||M.magFilter===_a||M.magFilter===xs||M.minFilter===Ri||M.minFilter===Fc||M.minFilter===_a||M.minFilter===xs)&&Yt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,Gt[M.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,Gt[M.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,Gt[M.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ie[M.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ie[M.minFilter]),M.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Vt[M.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Ai||M.minFilter!==_a&&M.minFilter!==xs||M.type===Wi&&t.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let W=t.get("EXT_texture_filter_anisotropic");n.texParameterf(R,W.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function re(R,M){let W=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",I),k(M));let ht=M.source,ot=f.get(ht);ot===void 0&&(ot={},f.set(ht,ot));let _t=tt(M);if(_t!==R.__cacheKey){ot[_t]===void 0&&(ot[_t]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,W=!0),ot[_t].usedTimes++;let vt=ot[R.__cacheKey];vt!==void 0&&(ot[R.__cacheKey].usedTimes--,vt.usedTimes===0&&z(M)),R.__cacheKey=_t,R.__webglTexture=ot[_t].texture}return W}function te(R,M,W){return Math.floor(Math.floor(R/W)/M)}function Ge(R,M,W,ht){let _t=R.updateRanges;if(_t.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,W,ht,M.data);else{_t.sort((F,rt)=>F.start-rt.start);let vt=0;for(let F=1;F<_t.length;F++){let rt=_t[vt],it=_t[F],wt=rt.start+rt.count,gt=te(it.start,M.width,4),Mt=te(rt.start,M.width,4);it.start<=wt+1&&gt===Mt&&te(it.start+it.count-1,M.width,4)===gt?rt.count=Math.max(rt.count,it.start+it.count-rt.start):(++vt,_t[vt]=it)}_t.length=vt+1;let et=e.getParameter(n.UNPACK_ROW_LENGTH),nt=e.getParameter(n.UNPACK_SKIP_PIXELS),pt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let F=0,rt=_t.length;F<rt;F++){let it=_t[F],wt=Math.floor(it.start/4),gt=Math.ceil(it.count/4),Mt=wt%M.width,Ht=Math.floor(wt/M.width),Zt=gt,lt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Mt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Ht),e.texSubImage2D(n.TEXTURE_2D,0,Mt,Ht,Zt,lt,W,ht,M.data)}R.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,et),e.pixelStorei(n.UNPACK_SKIP_PIXELS,nt),e.pixelStorei(n.UNPACK_SKIP_ROWS,pt)}}function Fe(R,M,W){let ht=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ht=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ht=n.TEXTURE_3D);let ot=re(R,M),_t=M.source;e.bindTexture(ht,R.__webglTexture,n.TEXTURE0+W);let vt=i.get(_t);if(_t.version!==vt.__version||ot===!0){if(e.activeTexture(n.TEXTURE0+W),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let lt=pe.getPrimaries(pe.workingColorSpace),Ot=M.colorSpace===ys?null:pe.getPrimaries(M.colorSpace),Jt=M.colorSpace===ys||lt===Ot?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Jt)}e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let nt=v(M.image,!1,s.maxTextureSize);nt=zt(M,nt);let pt=r.convert(M.format,M.colorSpace),F=r.convert(M.type),rt=T(M.internalFormat,pt,F,M.normalized,M.colorSpace,M.isVideoTexture);le(ht,M);let it,wt=M.mipmaps,gt=M.isVideoTexture!==!0,Mt=vt.__version===void 0||ot===!0,Ht=_t.dataReady,Zt=E(M,nt);if(M.isDepthTexture)rt=x(M.format===vs,M.type),Mt&&(gt?e.texStorage2D(n.TEXTURE_2D,1,rt,nt.width,nt.height):e.texImage2D(n.TEXTURE_2D,0,rt,nt.width,nt.height,0,pt,F,null));else if(M.isDataTexture)if(wt.length>0){gt&&Mt&&e.texStorage2D(n.TEXTURE_2D,Zt,rt,wt[0].width,wt[0].height);for(let lt=0,Ot=wt.length;lt<Ot;lt++)it=wt[lt],gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,lt,0,0,it.width,it.height,pt,F,it.data):e.texImage2D(n.TEXTURE_2D,lt,rt,it.width,it.height,0,pt,F,it.data);M.generateMipmaps=!1}else gt?(Mt&&e.texStorage2D(n.TEXTURE_2D,Zt,rt,nt.width,nt.height),Ht&&Ge(M,nt,pt,F)):e.texImage2D(n.TEXTURE_2D,0,rt,nt.width,nt.height,0,pt,F,nt.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){gt&&Mt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Zt,rt,wt[0].width,wt[0].height,nt.depth);for(let lt=0,Ot=wt.length;lt<Ot;lt++)if(it=wt[lt],M.format!==Xi)if(pt!==null)if(gt){if(Ht)if(M.layerUpdates.size>0){let Jt=Xd(it.width,it.height,M.format,M.type);for(let Rt of M.layerUpdates){let se=it.data.subarray(Rt*Jt/it.data.BYTES_PER_ELEMENT,(Rt+1)*Jt/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,lt,0,0,Rt,it.width,it.height,1,pt,se)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,lt,0,0,0,it.width,it.height,nt.depth,pt,it.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,lt,rt,it.width,it.height,nt.depth,0,it.data,0,0);else Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else gt?Ht&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,lt,0,0,0,it.width,it.height,nt.depth,pt,F,it.data):e.texImage3D(n.TEXTURE_2D_ARRAY,lt,rt,it.width,it.height,nt.depth,0,pt,F,it.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{gt&&Mt&&e.texStorage2D(n.TEXTURE_2D,Zt,rt,wt[0].width,wt[0].height);for(let lt=0,Ot=wt.length;lt<Ot;lt++)it=wt[lt],M.format!==Xi?pt!==null?gt?Ht&&e.compressedTexSubImage2D(n.TEXTURE_2D,lt,0,0,it.width,it.height,pt,it.data):e.compressedTexImage2D(n.TEXTURE_2D,lt,rt,it.width,it.height,0,it.data):Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,lt,0,0,it.width,it.height,pt,F,it.data):e.texImage2D(n.TEXTURE_2D,lt,rt,it.width,it.height,0,pt,F,it.data)}else if(M.isDataArrayTexture)if(gt){if(Mt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Zt,rt,nt.width,nt.height,nt.depth),Ht)if(M.layerUpdates.size>0){let lt=Xd(nt.width,nt.height,M.format,M.type);for(let Ot of M.layerUpdates){let Jt=nt.data.subarray(Ot*lt/nt.data.BYTES_PER_ELEMENT,(Ot+1)*lt/nt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ot,nt.width,nt.height,1,pt,F,Jt)}M.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,nt.width,nt.height,nt.depth,pt,F,nt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,nt.width,nt.height,nt.depth,0,pt,F,nt.data);else if(M.isData3DTexture)gt?(Mt&&e.texStorage3D(n.TEXTURE_3D,Zt,rt,nt.width,nt.height,nt.depth),Ht&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,nt.width,nt.height,nt.depth,pt,F,nt.data)):e.texImage3D(n.TEXTURE_3D,0,rt,nt.width,nt.height,nt.depth,0,pt,F,nt.data);else if(M.isFramebufferTexture){if(Mt)if(gt)e.texStorage2D(n.TEXTURE_2D,Zt,rt,nt.width,nt.height);else{let lt=nt.width,Ot=nt.height;for(let Jt=0;Jt<Zt;Jt++)e.texImage2D(n.TEXTURE_2D,Jt,rt,lt,Ot,0,pt,F,null),lt>>=1,Ot>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let lt=n.canvas;if(lt.hasAttribute("layoutsubtree")||lt.setAttribute("layoutsubtree","true"),nt.parentNode!==lt){lt.appendChild(nt),u.add(M),lt.onpaint=Ot=>{let Jt=Ot.changedElements;for(let Rt of u)Jt.includes(Rt.image)&&(Rt.needsUpdate=!0)},lt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,nt);else{let Jt=n.RGBA,Rt=n.RGBA,se=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Jt,Rt,se,nt)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(wt.length>0){if(gt&&Mt){let lt=Xt(wt[0]);e.texStorage2D(n.TEXTURE_2D,Zt,rt,lt.width,lt.height)}for(let lt=0,Ot=wt.length;lt<Ot;lt++)it=wt[lt],gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,lt,0,0,pt,F,it):e.texImage2D(n.TEXTURE_2D,lt,rt,pt,F,it);M.generateMipmaps=!1}else if(gt){if(Mt){let lt=Xt(nt);e.texStorage2D(n.TEXTURE_2D,Zt,rt,lt.width,lt.height)}Ht&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,pt,F,nt)}else e.texImage2D(n.TEXTURE_2D,0,rt,pt,F,nt);A(M)&&M.mipmapsAutoUpdate===!0&&S(ht),vt.__version=_t.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function ni(R,M,W){if(M.image.length!==6)return;let ht=re(R,M),ot=M.source;e.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+W);let _t=i.get(ot);if(ot.version!==_t.__version||ht===!0){e.activeTexture(n.TEXTURE0+W);let vt=pe.getPrimaries(pe.workingColorSpace),et=M.colorSpace===ys?null:pe.getPrimaries(M.colorSpace),nt=M.colorSpace===ys||vt===et?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt);let pt=M.isCompressedTexture||M.image[0].isCompressedTexture,F=M.image[0]&&M.image[0].isDataTexture,rt=[];for(let Rt=0;Rt<6;Rt++)!pt&&!F?rt[Rt]=v(M.image[Rt],!0,s.maxCubemapSize):rt[Rt]=F?M.image[Rt].image:M.image[Rt],rt[Rt]=zt(M,rt[Rt]);let it=rt[0],wt=r.convert(M.format,M.colorSpace),gt=r.convert(M.type),Mt=T(M.internalFormat,wt,gt,M.normalized,M.colorSpace),Ht=M.isVideoTexture!==!0,Zt=_t.__version===void 0||ht===!0,lt=ot.dataReady,Ot=E(M,it);le(n.TEXTURE_CUBE_MAP,M);let Jt;if(M.isDepthTexture){if(Mt=x(M.format===vs,M.type),Zt)if(Ht)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Mt,it.width,it.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,it.width,it.height,0,wt,gt,null)}else if(pt){Ht&&Zt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ot,Mt,it.width,it.height);for(let Rt=0;Rt<6;Rt++){Jt=rt[Rt].mipmaps;for(let se=0;se<Jt.length;se++){let Oe=Jt[se];M.format!==Xi?wt!==null?Ht?lt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se,0,0,Oe.width,Oe.height,wt,Oe.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se,Mt,Oe.width,Oe.height,0,Oe.data):Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ht?lt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se,0,0,Oe.width,Oe.height,wt,gt,Oe.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se,Mt,Oe.width,Oe.height,0,wt,gt,Oe.data)}}}else{if(Jt=M.mipmaps,Ht&&Zt){Jt.length>0&&Ot++;let Rt=Xt(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ot,Mt,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(F){Ht?lt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,rt[Rt].width,rt[Rt].height,wt,gt,rt[Rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,rt[Rt].width,rt[Rt].height,0,wt,gt,rt[Rt].data);for(let se=0;se<Jt.length;se++){let Oi=Jt[se].image[Rt].image;Ht?lt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se+1,0,0,Oi.width,Oi.height,wt,gt,Oi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se+1,Mt,Oi.width,Oi.height,0,wt,gt,Oi.data)}}else{Ht?lt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,wt,gt,rt[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,wt,gt,rt[Rt]);for(let se=0;se<Jt.length;se++){let Oe=Jt[se];Ht?lt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se+1,0,0,wt,gt,Oe.image[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,se+1,Mt,wt,gt,Oe.image[Rt])}}}A(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),_t.__version=ot.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Ce(R,M,W,ht,ot,_t){let vt=r.convert(W.format,W.colorSpace),et=r.convert(W.type),nt=T(W.internalFormat,vt,et,W.normalized,W.colorSpace),pt=i.get(M),F=i.get(W);if(F.__renderTarget=M,!pt.__hasExternalTextures){let rt=Math.max(1,M.width>>_t),it=Math.max(1,M.height>>_t);ot===n.TEXTURE_3D||ot===n.TEXTURE_2D_ARRAY?e.texImage3D(ot,_t,nt,rt,it,M.depth,0,vt,et,null):e.texImage2D(ot,_t,nt,rt,it,0,vt,et,null)}e.bindFramebuffer(n.FRAMEBUFFER,R),bt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ht,ot,F.__webglTexture,0,ne(M)):(ot===n.TEXTURE_2D||ot>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ht,ot,F.__webglTexture,_t),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Mi(R,M,W){if(n.bindRenderbuffer(n.RENDERBUFFER,R),M.depthBuffer){let ht=M.depthTexture,ot=ht&&ht.isDepthTexture?ht.type:null,_t=x(M.stencilBuffer,ot),vt=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;bt(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ne(M),_t,M.width,M.height):W?n.renderbufferStorageMultisample(n.RENDERBUFFER,ne(M),_t,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,_t,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,vt,n.RENDERBUFFER,R)}else{let ht=M.textures;for(let ot=0;ot<ht.length;ot++){let _t=ht[ot],vt=r.convert(_t.format,_t.colorSpace),et=r.convert(_t.type),nt=T(_t.internalFormat,vt,et,_t.normalized,_t.colorSpace);bt(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ne(M),nt,M.width,M.height):W?n.renderbufferStorageMultisample(n.RENDERBUFFER,ne(M),nt,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,nt,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function _e(R,M,W){let ht=M.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=i.get(M.depthTexture);ot.__renderTarget=M;let _t=ht?M.depthTexture.image[0]:M.depthTexture.image;(!ot.__webglTexture||_t.width!==M.width||_t.height!==M.height)&&(_t.width=M.width,_t.height=M.height,M.depthTexture.needsUpdate=!0),ht?St(M.depthTexture,0):mt(M.depthTexture,0);let vt=ot.__webglTexture,et=ne(M),nt=ht?n.TEXTURE_CUBE_MAP_POSITIVE_X+W:n.TEXTURE_2D,pt=M.depthTexture.format===vs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===ms)bt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,nt,vt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,pt,nt,vt,0);else if(M.depthTexture.format===vs)bt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,nt,vt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,pt,nt,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function pi(R){let M=i.get(R),W=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ht=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ht){let ot=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ht.removeEventListener("dispose",ot)};ht.addEventListener("dispose",ot),M.__depthDisposeCallback=ot}M.__boundDepthTexture=ht}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(W)for(let ht=0;ht<6;ht++)_e(M.__webglFramebuffer[ht],R,ht);else R.texture.mipmaps.length>0?_e(M.__webglFramebuffer[0],R,0):_e(M.__webglFramebuffer,R,0);else if(W){M.__webglDepthbuffer=[];for(let ht=0;ht<6;ht++)if(e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ht]),M.__webglDepthbuffer[ht]===void 0)M.__webglDepthbuffer[ht]=n.createRenderbuffer(),Mi(M.__webglDepthbuffer[ht],R,!1);else{let ot=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=M.__webglDepthbuffer[ht];n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,_t)}}else if(R.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),Mi(M.__webglDepthbuffer,R,!1);else{let ot=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,_t)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ye(R,M,W){let ht=i.get(R);M!==void 0&&Ce(ht.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),W!==void 0&&pi(R)}function si(R){let M=R.texture,W=i.get(R),ht=i.get(M);R.addEventListener("dispose",V),k(R);let ot=R.textures,_t=R.isWebGLCubeRenderTarget===!0,vt=ot.length>1;if(vt||(ht.__webglTexture===void 0&&(ht.__webglTexture=n.createTexture()),ht.__version=M.version,o.memory.textures++),_t){W.__webglFramebuffer=[];for(let et=0;et<6;et++)if(M.mipmaps.length>0){W.__webglFramebuffer[et]=[];for(let nt=0;nt<M.mipmaps.length;nt++)W.__webglFramebuffer[et][nt]=n.createFramebuffer()}else W.__webglFramebuffer[et]=n.createFramebuffer()}else{if(M.mipmaps.length>0){W.__webglFramebuffer=[];for(let et=0;et<M.mipmaps.length;et++)W.__webglFramebuffer[et]=n.createFramebuffer()}else W.__webglFramebuffer=n.createFramebuffer();if(vt)for(let et=0,nt=ot.length;et<nt;et++){let pt=i.get(ot[et]);pt.__webglTexture===void 0&&(pt.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&bt(R)===!1){W.__webglMultisampledFramebuffer=n.createFramebuffer(),W.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,W.__webglMultisampledFramebuffer);for(let et=0;et<ot.length;et++){let nt=ot[et];W.__webglColorRenderbuffer[et]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,W.__webglColorRenderbuffer[et]);let pt=r.convert(nt.format,nt.colorSpace),F=r.convert(nt.type),rt=T(nt.internalFormat,pt,F,nt.normalized,nt.colorSpace,R.isXRRenderTarget===!0),it=ne(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,it,rt,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+et,n.RENDERBUFFER,W.__webglColorRenderbuffer[et])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(W.__webglDepthRenderbuffer=n.createRenderbuffer(),Mi(W.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_t){e.bindTexture(n.TEXTURE_CUBE_MAP,ht.__webglTexture),le(n.TEXTURE_CUBE_MAP,M);for(let et=0;et<6;et++)if(M.mipmaps.length>0)for(let nt=0;nt<M.mipmaps.length;nt++)Ce(W.__webglFramebuffer[et][nt],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,nt);else Ce(W.__webglFramebuffer[et],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);A(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let et=0,nt=ot.length;et<nt;et++){let pt=ot[et],F=i.get(pt),rt=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(rt=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,F.__webglTexture),le(rt,pt),Ce(W.__webglFramebuffer,R,pt,n.COLOR_ATTACHMENT0+et,rt,0),A(pt)&&S(rt)}e.unbindTexture()}else{let et=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(et=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(et,ht.__webglTexture),le(et,M),M.mipmaps.length>0)for(let nt=0;nt<M.mipmaps.length;nt++)Ce(W.__webglFramebuffer[nt],R,M,n.COLOR_ATTACHMENT0,et,nt);else Ce(W.__webglFramebuffer,R,M,n.COLOR_ATTACHMENT0,et,0);A(M)?S(et):M.mipmaps.length>0&&n.texParameteri(et,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}R.depthBuffer&&pi(R)}function U(R){let M=R.textures;for(let W=0,ht=M.length;W<ht;W++){let ot=M[W];if(A(ot)&&ot.mipmapsAutoUpdate===!0){let _t=C(R),vt=i.get(ot).__webglTexture;e.bindTexture(_t,vt),S(_t),e.unbindTexture()}}}let Ct=[];function $t(R){if(R.samples>0){if(bt(R)===!1){let M=R.textures,W=R.width,ht=R.height,ot=n.COLOR_BUFFER_BIT,_t=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=i.get(R),et=M.length>1;if(et)for(let pt=0;pt<M.length;pt++)e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let pt=0;pt<M.length;pt++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ot|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ot|=n.STENCIL_BUFFER_BIT)),et){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,vt.__webglColorRenderbuffer[pt]);let F=i.get(M[pt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,W,ht,0,0,W,ht,ot,n.NEAREST),c===!0&&(Ct.length=0,Ct.push(n.COLOR_ATTACHMENT0+pt),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Ct.push(_t),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ct))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),et)for(let pt=0;pt<M.length;pt++){e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,vt.__webglColorRenderbuffer[pt]);let F=i.get(M[pt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,F,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&c){let M=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function ne(R){return Math.min(s.maxSamples,R.samples)}function bt(R){let M=i.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Le(R){let M=o.render.frame;h.get(R)!==M&&(h.set(R,M),R.update())}function zt(R,M){let W=R.colorSpace,ht=R.format,ot=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||W!==Fs&&W!==ys&&(pe.getTransfer(W)===Ee?(ht!==Xi||ot!==cn)&&Yt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):jt("WebGLTextures: Unsupported texture color space:",W)),M}function Xt(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(l.width=R.naturalWidth||R.width,l.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(l.width=R.displayWidth,l.height=R.displayHeight):(l.width=R.width,l.height=R.height),l}this.allocateTextureUnit=ut,this.resetTextureUnits=Q,this.getTextureUnits=st,this.setTextureUnits=dt,this.setTexture2D=mt,this.setTexture2DArray=xt,this.setTexture3D=At,this.setTextureCube=St,this.rebindTextures=Ye,this.setupRenderTarget=si,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=$t,this.setupDepthRenderbuffer=pi,this.setupFrameBufferTexture=Ce,this.useMultisampledRTT=bt,this.dispose=H}function G1(n,t){function e(i,s=ys){let r,o=pe.getTransfer(s);if(i===cn)return n.UNSIGNED_BYTE;if(i===Oc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===kc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Id)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Ld)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Cd)return n.BYTE;if(i===Pd)return n.SHORT;if(i===vo)return n.UNSIGNED_SHORT;if(i===Uc)return n.INT;if(i===Fn)return n.UNSIGNED_INT;if(i===Wi)return n.FLOAT;if(i===Un)return n.HALF_FLOAT;if(i===Nd)return n.ALPHA;if(i===Dd)return n.RGB;if(i===Xi)return n.RGBA;if(i===ms)return n.DEPTH_COMPONENT;if(i===vs)return n.DEPTH_STENCIL;if(i===Fd)return n.RED;if(i===Bc)return n.RED_INTEGER;if(i===Gs)return n.RG;if(i===zc)return n.RG_INTEGER;if(i===Vc)return n.RGBA_INTEGER;if(i===xa||i===va||i===ya||i===Ma)if(o===Ee)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===xa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ma)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===xa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===va)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ya)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ma)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Hc||i===Gc||i===Wc||i===Xc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Hc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Gc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Wc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Xc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===$c||i===qc||i===Yc||i===Zc||i===Jc||i===Sa||i===Kc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===$c||i===qc)return o===Ee?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Yc)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Zc)return r.COMPRESSED_R11_EAC;if(i===Jc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Sa)return r.COMPRESSED_RG11_EAC;if(i===Kc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===jc||i===Qc||i===th||i===eh||i===ih||i===nh||i===sh||i===rh||i===oh||i===ah||i===lh||i===ch||i===hh||i===uh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===jc)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Qc)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===th)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===eh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===ih)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===nh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===sh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===rh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===oh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===ah)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===lh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===ch)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===hh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===uh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===dh||i===fh||i===ph)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===dh)return o===Ee?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===fh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===ph)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===mh||i===gh||i===ba||i===_h)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===mh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===gh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ba)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===_h)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===pr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var W1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,X1=`
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

}`,tf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new fa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new jn({vertexShader:W1,fragmentShader:X1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new fi(new pa(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ef=class extends Jn{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,u=null,d=null,f=null,g=null,y=typeof XRWebGLBinding<"u",m=new tf,p={},v=e.getContextAttributes(),A=null,S=null,C=[],T=[],x=new xe,E=null,k=null,N=new rn;N.viewport=new Ie;let I=new rn;I.viewport=new Ie;let V=[N,I],G=new Lc,D=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let mt=C[tt];return mt===void 0&&(mt=new uo,C[tt]=mt),mt.getTargetRaySpace()},this.getControllerGrip=function(tt){let mt=C[tt];return mt===void 0&&(mt=new uo,C[tt]=mt),mt.getGripSpace()},this.getHand=function(tt){let mt=C[tt];return mt===void 0&&(mt=new uo,C[tt]=mt),mt.getHandSpace()};function Z(tt){let mt=T.indexOf(tt.inputSource);if(mt===-1)return;let xt=C[mt];xt!==void 0&&(xt.update(tt.inputSource,tt.frame,l||o),xt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function z(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",ct);for(let tt=0;tt<C.length;tt++){let mt=T[tt];mt!==null&&(T[tt]=null,C[tt].disconnect(mt))}D=null,H=null,m.reset();for(let tt in p)delete p[tt];if(t.setRenderTarget(A),f=null,d=null,u=null,s=null,S=null,ut.stop(),i.isPresenting=!1,t.setPixelRatio(E),t.setSize(x.width,x.height,!1),k!==null){let tt=k.camera;tt.fov=k.fov,tt.zoom=k.zoom,tt.updateProjectionMatrix(),k=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&Yt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&Yt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(tt){l=tt},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",z),s.addEventListener("inputsourceschange",ct),v.xrCompatible!==!0&&await e.makeXRCompatible(),E=t.getPixelRatio(),t.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,At=null,St=null;v.depth&&(St=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=v.stencil?vs:ms,At=v.stencil?pr:Fn);let Gt={colorFormat:e.RGBA8,depthFormat:St,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Gt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),S=new on(d.textureWidth,d.textureHeight,{format:Xi,type:cn,depthTexture:new _s(d.textureWidth,d.textureHeight,At,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new on(f.framebufferWidth,f.framebufferHeight,{format:Xi,type:cn,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),ut.setContext(s),ut.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ct(tt){for(let mt=0;mt<tt.removed.length;mt++){let xt=tt.removed[mt],At=T.indexOf(xt);At>=0&&(T[At]=null,C[At].disconnect(xt))}for(let mt=0;mt<tt.added.length;mt++){let xt=tt.added[mt],At=T.indexOf(xt);if(At===-1){for(let Gt=0;Gt<C.length;Gt++)if(Gt>=T.length){T.push(xt),At=Gt;break}else if(T[Gt]===null){T[Gt]=xt,At=Gt;break}if(At===-1)break}let St=C[At];St&&St.connect(xt)}}function J(tt,mt){mt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(mt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let mt=tt.near,xt=tt.far;m.texture!==null&&(m.depthNear>0&&(mt=m.depthNear),m.depthFar>0&&(xt=m.depthFar)),G.near=I.near=N.near=mt,G.far=I.far=N.far=xt,(D!==G.near||H!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),D=G.near,H=G.far),G.layers.mask=tt.layers.mask|6,N.layers.mask=G.layers.mask&-5,I.layers.mask=G.layers.mask&-3;let At=tt.parent,St=G.cameras;J(G,At);for(let Gt=0;Gt<St.length;Gt++)J(St[Gt],At);G.projectionMatrix.copy(N.projectionMatrix),G.projectionMatrixInverse.copy(N.projectionMatrixInverse),k===null&&tt.isPerspectiveCamera&&(k={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,G,At)};function Q(tt,mt,xt){xt===null?tt.matrix.copy(mt.matrixWorld):(tt.matrix.copy(xt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(mt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(mt.projectionMatrix),tt.projectionMatrixInverse.copy(mt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=dc*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(tt){c=tt,d!==null&&(d.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(G)},this.getCameraTexture=function(tt){return p[tt]};let st=null;function dt(tt,mt){if(h=mt.getViewerPose(l||o),g=mt,h!==null){let xt=h.views;f!==null&&(t.setRenderTargetFramebuffer(S,f.framebuffer),t.setRenderTarget(S));let At=!1;xt.length!==G.cameras.length&&(G.cameras.length=0,At=!0);for(let Vt=0;Vt<xt.length;Vt++){let le=xt[Vt],re=null;if(f!==null)re=f.getViewport(le);else{let Ge=u.getViewSubImage(d,le);re=Ge.viewport,Vt===0&&(t.setRenderTargetTextures(S,Ge.colorTexture,Ge.depthStencilTexture),t.setRenderTarget(S))}let te=V[Vt];te===void 0&&(te=new rn,te.layers.enable(Vt),te.viewport=new Ie,V[Vt]=te),te.matrix.fromArray(le.transform.matrix),te.matrix.decompose(te.position,te.quaternion,te.scale),te.projectionMatrix.fromArray(le.projectionMatrix),te.projectionMatrixInverse.copy(te.projectionMatrix).invert(),te.viewport.set(re.x,re.y,re.width,re.height),Vt===0&&(G.matrix.copy(te.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),At===!0&&G.cameras.push(te)}let St=s.enabledFeatures;if(St&&St.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=i.getBinding();let Vt=u.getDepthInformation(xt[0]);Vt&&Vt.isValid&&Vt.texture&&m.init(Vt,s.renderState)}if(St&&St.includes("camera-access")&&y){t.state.unbindTexture(),u=i.getBinding();for(let Vt=0;Vt<xt.length;Vt++){let le=xt[Vt].camera;if(le){let re=p[le];re||(re=new fa,p[le]=re);let te=u.getCameraImage(le);re.sourceTexture=te}}}}for(let xt=0;xt<C.length;xt++){let At=T[xt],St=C[xt];At!==null&&St!==void 0&&St.update(At,mt,l||o)}st&&st(tt,mt),mt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:mt}),g=null}let ut=new m0;ut.setAnimationLoop(dt),this.setAnimationLoop=function(tt){st=tt},this.dispose=function(){}}},$1=new Ue,E0=new Qt;E0.set(-1,0,0,0,1,0,0,0,1);function q1(n,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,Hd(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,v,A,S){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),u(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),d(m,p),p.isMeshPhysicalMaterial&&f(m,p,S)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),y(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?c(m,p,v,A):p.isSpriteMaterial?l(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Gi&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Gi&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let v=t.get(p),A=v.envMap,S=v.envMapRotation;A&&(m.envMap.value=A,m.envMapRotation.value.setFromMatrix4($1.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(E0),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function c(m,p,v,A){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*v,m.scale.value=A*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function l(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function u(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function d(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,v){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Gi&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function y(m,p){let v=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Y1(n,t,e,i){let s={},r={};function o(v,A){let S=A.program;i.uniformBlockBinding(v,S,s[v.id])}function a(v,A){let S=s[v.id];S===void 0&&(g(v),S=c(v),s[v.id]=S,v.addEventListener("dispose",m));let C=A.program;i.updateUBOMapping(v,C);let T=t.render.frame;r[v.id]!==T&&(l(v),r[v.id]=T)}function c(v){let A=n.createBuffer(),S=v.__size,C=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,S,C),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function l(v){let A=s[v.id],S=v.uniforms,C=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let T=0,x=S.length;T<x;T++){let E=S[T];if(Array.isArray(E))for(let k=0,N=E.length;k<N;k++)h(E[k],T,k,C);else h(E,T,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(v,A,S,C){if(d(v,A,S,C)===!0){let T=v.__offset,x=v.value;if(Array.isArray(x)){let E=0;for(let k=0;k<x.length;k++){let N=x[k],I=y(N,!0);u(N,v.__data,E),E+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,v.__data)}}function u(v,A,S){typeof v=="number"||typeof v=="boolean"?A[S]=v:v.isMatrix3?(A[S]=v.elements[0],A[S+1]=v.elements[1],A[S+2]=v.elements[2],A[S+3]=0,A[S+4]=v.elements[3],A[S+5]=v.elements[4],A[S+6]=v.elements[5],A[S+7]=0,A[S+8]=v.elements[6],A[S+9]=v.elements[7],A[S+10]=v.elements[8],A[S+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-S),S):v.toArray(A,S)}function d(v,A,S,C){let T=v.value,x=A+"_"+S;if(Array.isArray(T)){C[x]===void 0&&(C[x]=[]);let E=C[x],k=!1;for(let N=0;N<T.length;N++)f(T[N],E,N)===!0&&(k=!0);return k}return f(T,C,x)}function f(v,A,S){if(A[S]===void 0)return typeof v=="number"||typeof v=="boolean"?A[S]=v:ArrayBuffer.isView(v)?A[S]=v.slice():A[S]=v.clone(),!0;{let C=A[S];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return A[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function g(v){let A=v.uniforms,S=0,C=16;for(let x=0,E=A.length;x<E;x++){let k=Array.isArray(A[x])?A[x]:[A[x]];for(let N=0,I=k.length;N<I;N++){let V=k[N],G=Array.isArray(V.value)?V.value:[V.value],D=Array.isArray(A[x])||Array.isArray(V.value),H=S;for(let z=0,ct=G.length;z<ct;z++){let J=G[z],Q=y(J,D),st=S%C,dt=st%Q.boundary,ut=st+dt;S+=dt,ut!==0&&C-ut<Q.storage&&(S+=C-ut),z===0&&(H=S),S+=Q.storage}let Z=V.type==="int"?Int32Array:V.type==="uint"?Uint32Array:Float32Array;V.__data=new Z((S-H)/Float32Array.BYTES_PER_ELEMENT),V.__offset=H}}let T=S%C;return T>0&&(S+=C-T),v.__size=S,v.__cache={},this}function y(v,A){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Yt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Yt("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(v){let A=v.target;A.removeEventListener("dispose",m),n.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function p(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:p}}var Z1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ts=null;function J1(){return ts===null&&(ts=new gs(Z1,16,16,Gs,Un),ts.name="DFG_LUT",ts.minFilter=Ri,ts.magFilter=Ri,ts.wrapS=Zn,ts.wrapT=Zn,ts.generateMipmaps=!1,ts.needsUpdate=!0),ts}var Mh=class{constructor(t={}){let{canvas:e=Bg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=cn}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let y=f,m=new Set([Vc,zc,Bc]),p=new Set([cn,Fn,vo,pr,Oc,kc]),v=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,T=null,x=[],E=[],k=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Qn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,I=!1,V=null,G=null,D=null,H=null;this._outputColorSpace=sn;let Z=0,z=0,ct=null,J=-1,Q=null,st=new Ie,dt=new Ie,ut=null,tt=new me(0),mt=0,xt=e.width,At=e.height,St=1,Gt=null,ie=null,Vt=new Ie(0,0,xt,At),le=new Ie(0,0,xt,At),re=!1,te=new lr,Ge=new _c,Fe=!1,ni=!1,Ce=new Ue,Mi=new K,_e=new Ie,pi={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ye=!1;function si(){return ct===null?St:1}let U=i;function Ct(w,O){return e.getContext(w,O)}let $t,ne,bt,Le,zt,Xt,R,M,W,ht,ot,_t,vt,et,nt,pt,F,rt,it,wt,gt,Mt,Ht;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ot,!1),e.addEventListener("webglcontextrestored",Jt,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),U===null){let O="webgl2";if(U=Ct(O,w),U===null)throw Ct(O)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Zt()}catch(w){throw e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Jt,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),jt("WebGLRenderer: "+w.message),w}function Zt(){$t=new aw(U),$t.init(),gt=new G1(U,$t),ne=new Jb(U,$t,t,gt),bt=new V1(U,$t),ne.reversedDepthBuffer&&d&&bt.buffers.depth.setReversed(!0),G=U.createFramebuffer(),D=U.createFramebuffer(),H=U.createFramebuffer(),Le=new hw(U),zt=new A1,Xt=new H1(U,$t,bt,zt,ne,gt,Le),R=new ow(N),M=new dM(U),Mt=new Yb(U,M),W=new lw(U,M,Le,Mt),ht=new dw(U,W,M,Mt,Le),rt=new uw(U,ne,Xt),nt=new Kb(zt),ot=new T1(N,R,$t,ne,Mt,nt),_t=new q1(N,zt),vt=new C1,et=new F1($t),F=new qb(N,R,bt,ht,g,c),pt=new z1(N,ht,ne),Ht=new Y1(U,Le,ne,bt),it=new Zb(U,$t,Le),wt=new cw(U,$t,Le),Le.programs=ot.programs,N.capabilities=ne,N.extensions=$t,N.properties=zt,N.renderLists=vt,N.shadowMap=pt,N.state=bt,N.info=Le}y!==cn&&(k=new pw(y,e.width,e.height,a,s,r));let lt=new ef(N,U);this.xr=lt,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let w=$t.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=$t.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return St},this.setPixelRatio=function(w){w!==void 0&&(St=w,this.setSize(xt,At,!1))},this.getSize=function(w){return w.set(xt,At)},this.setSize=function(w,O,j=!0){if(lt.isPresenting){Yt("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=w,At=O,e.width=Math.floor(w*St),e.height=Math.floor(O*St),j===!0&&(e.style.width=w+"px",e.style.height=O+"px"),k!==null&&k.setSize(e.width,e.height),this.setViewport(0,0,w,O)},this.getDrawingBufferSize=function(w){return w.set(xt*St,At*St).floor()},this.setDrawingBufferSize=function(w,O,j){xt=w,At=O,St=j,e.width=Math.floor(w*j),e.height=Math.floor(O*j),this.setViewport(0,0,w,O)},this.setEffects=function(w){if(y===cn){jt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let O=0;O<w.length;O++)if(w[O].isOutputPass===!0){Yt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(st)},this.getViewport=function(w){return w.copy(Vt)},this.setViewport=function(w,O,j,$){w.isVector4?Vt.set(w.x,w.y,w.z,w.w):Vt.set(w,O,j,$),bt.viewport(st.copy(Vt).multiplyScalar(si()).round())},this.getScissor=function(w){return w.copy(le)},this.setScissor=function(w,O,j,$){w.isVector4?le.set(w.x,w.y,w.z,w.w):le.set(w,O,j,$),bt.scissor(dt.copy(le).multiplyScalar(si()).round())},this.getScissorTest=function(){return re},this.setScissorTest=function(w){bt.setScissorTest(re=w)},this.setOpaqueSort=function(w){Gt=w},this.setTransparentSort=function(w){ie=w},this.getClearColor=function(w){return w.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(w=!0,O=!0,j=!0){let $=0;if(w){let q=!1;if(ct!==null){let Et=ct.texture.format;q=m.has(Et)}if(q){let Et=ct.texture.type,Pt=p.has(Et),Tt=F.getClearColor(),It=F.getClearAlpha(),Bt=Tt.r,Kt=Tt.g,ce=Tt.b;Pt?(v[0]=Bt,v[1]=Kt,v[2]=ce,v[3]=It,U.clearBufferuiv(U.COLOR,0,v)):(A[0]=Bt,A[1]=Kt,A[2]=ce,A[3]=It,U.clearBufferiv(U.COLOR,0,A))}else $|=U.COLOR_BUFFER_BIT}O&&($|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&U.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),V=w},this.dispose=function(){e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Jt,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),F.dispose(),vt.dispose(),et.dispose(),Xt.dispose(),zt.dispose(),R.dispose(),ht.dispose(),W.dispose(),Mt.dispose(),Ht.dispose(),ot.dispose(),lt.dispose(),lt.removeEventListener("sessionstart",Ia),lt.removeEventListener("sessionend",kn),is.stop()};function Ot(w){w.preventDefault(),zd("WebGLRenderer: Context Lost."),I=!0}function Jt(){zd("WebGLRenderer: Context Restored."),I=!1;let w=Le.autoReset,O=pt.enabled,j=pt.autoUpdate,$=pt.needsUpdate,q=pt.type;Zt(),Le.autoReset=w,pt.enabled=O,pt.autoUpdate=j,pt.needsUpdate=$,pt.type=q}function Rt(w){jt("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function se(w){let O=w.target;O.removeEventListener("dispose",se),Oe(O)}function Oe(w){Oi(w),zt.remove(w)}function Oi(w){let O=zt.get(w).programs;O!==void 0&&(O.forEach(function(j){ot.releaseProgram(j)}),w.isShaderMaterial&&ot.releaseShaderCache(w))}this.renderBufferDirect=function(w,O,j,$,q,Et){O===null&&(O=pi);let Pt=q.isMesh&&q.matrixWorld.determinantAffine()<0,Tt=Eo(w,O,j,$,q);bt.setMaterial($,Pt);let It=j.index,Bt=1;if($.wireframe===!0){if(It=W.getWireframeAttribute(j),It===void 0)return;Bt=2}let Kt=j.drawRange,ce=j.attributes.position,kt=Kt.start*Bt,he=(Kt.start+Kt.count)*Bt;Et!==null&&(kt=Math.max(kt,Et.start*Bt),he=Math.min(he,(Et.start+Et.count)*Bt)),It!==null?(kt=Math.max(kt,0),he=Math.min(he,It.count)):ce!=null&&(kt=Math.max(kt,0),he=Math.min(he,ce.count));let qe=he-kt;if(qe<0||qe===1/0)return;Mt.setup(q,$,Tt,j,It);let Te,Ae=it;if(It!==null&&(Te=M.get(It),Ae=wt,Ae.setIndex(Te)),q.isMesh)$.wireframe===!0?(bt.setLineWidth($.wireframeLinewidth*si()),Ae.setMode(U.LINES)):Ae.setMode(U.TRIANGLES);else if(q.isLine){let mi=$.linewidth;mi===void 0&&(mi=1),bt.setLineWidth(mi*si()),q.isLineSegments?Ae.setMode(U.LINES):q.isLineLoop?Ae.setMode(U.LINE_LOOP):Ae.setMode(U.LINE_STRIP)}else q.isPoints?Ae.setMode(U.POINTS):q.isSprite&&Ae.setMode(U.TRIANGLES);if(q.isBatchedMesh)if($t.get("WEBGL_multi_draw"))Ae.renderMultiDraw(q._multiDrawStarts,q._multiDrawCounts,q._multiDrawCount);else{let mi=q._multiDrawStarts,Ft=q._multiDrawCounts,ri=q._multiDrawCount,de=It?M.get(It).bytesPerElement:1,ss=zt.get($).currentProgram.getUniforms();for(let oi=0;oi<ri;oi++)ss.setValue(U,"_gl_DrawID",oi),Ae.render(mi[oi]/de,Ft[oi])}else if(q.isInstancedMesh)Ae.renderInstances(kt,qe,q.count);else if(j.isInstancedBufferGeometry){let mi=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ft=Math.min(j.instanceCount,mi);Ae.renderInstances(kt,qe,Ft)}else Ae.render(kt,qe)};function So(w,O,j,$){V!==null&&w.isNodeMaterial&&V.setObject($,w),Fe===!0&&nt.setState(w,j,!1),w.transparent===!0&&w.side===Sn&&w.forceSinglePass===!1?(w.side=Gi,w.needsUpdate=!0,Bn(w,O,$),w.side=Hs,w.needsUpdate=!0,Bn(w,O,$),w.side=Sn):Bn(w,O,$)}this.compile=function(w,O,j=null){j===null&&(j=w),V!==null&&V.renderStart(w,O,j),T=et.get(j),T.init(O),E.push(T),j.traverseVisible(function(q){q.isLight&&q.layers.test(O.layers)&&(T.pushLight(q),q.castShadow&&T.pushShadow(q))}),w!==j&&w.traverseVisible(function(q){q.isLight&&q.layers.test(O.layers)&&(T.pushLight(q),q.castShadow&&T.pushShadow(q))}),T.setupLights(),V!==null&&V.updateLights(T.state.lightsArray),ni=this.localClippingEnabled,Fe=nt.init(this.clippingPlanes,ni),Fe===!0&&nt.setGlobalState(this.clippingPlanes,O),V!==null&&pt.render(T.state.shadowsArray,j,O);let $=new Set;return w.traverse(function(q){if(!(q.isMesh||q.isPoints||q.isLine||q.isSprite))return;let Et=q.material;if(Et)if(Array.isArray(Et))for(let Pt=0;Pt<Et.length;Pt++){let Tt=Et[Pt];So(Tt,j,O,q),$.add(Tt)}else So(Et,j,O,q),$.add(Et)}),T=E.pop(),V!==null&&V.renderEnd(),$},this.compileAsync=function(w,O,j=null){let $=this.compile(w,O,j);return new Promise(q=>{function Et(){if($.forEach(function(Pt){let It=zt.get(Pt).currentProgram;(It===void 0||It.isReady())&&$.delete(Pt)}),$.size===0){q(w);return}setTimeout(Et,10)}$t.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let xr=null;function Nh(w){xr&&xr(w)}function Ia(){is.stop()}function kn(){is.start()}let is=new m0;is.setAnimationLoop(Nh),typeof self<"u"&&is.setContext(self),this.setAnimationLoop=function(w){xr=w,lt.setAnimationLoop(w),w===null?is.stop():is.start()},lt.addEventListener("sessionstart",Ia),lt.addEventListener("sessionend",kn),this.render=function(w,O){if(O!==void 0&&O.isCamera!==!0){jt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;V!==null&&V.renderStart(w,O);let j=lt.enabled===!0&&lt.isPresenting===!0,$=k!==null&&(ct===null||j)&&k.begin(N,ct);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),lt.enabled===!0&&lt.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(lt.cameraAutoUpdate===!0&&lt.updateCamera(O),O=lt.getCamera()),w.isScene===!0&&w.onBeforeRender(N,w,O,ct),T=et.get(w,E.length),T.init(O),T.state.textureUnits=Xt.getTextureUnits(),E.push(T),Ce.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),O.isArrayCamera?Ge.setFromArrayCamera(O):te.setFromProjectionMatrix(Ce,yn,O.reversedDepth),ni=this.localClippingEnabled,Fe=nt.init(this.clippingPlanes,ni),C=vt.get(w,x.length),C.init(),x.push(C),this.info.render.frame++,lt.enabled===!0&&lt.isPresenting===!0){let Pt=N.xr.getDepthSensingMesh();Pt!==null&&ns(Pt,O,-1/0,N.sortObjects)}ns(w,O,0,N.sortObjects),C.finish(),V!==null&&V.updateLights(T.state.lightsArray),N.sortObjects===!0&&C.sort(Gt,ie),Ye=lt.enabled===!1||lt.isPresenting===!1||lt.hasDepthSensing()===!1,Ye&&F.addToRenderList(C,w),this.info.autoReset===!0&&this.info.reset(),Fe===!0&&nt.beginShadows();let q=T.state.shadowsArray;if(pt.render(q,w,O),Fe===!0&&nt.endShadows(),($&&k.hasRenderPass())===!1){let Pt=C.opaque,Tt=C.transmissive;if(T.setupLights(),O.isArrayCamera){let It=O.cameras;if(Tt.length>0)for(let Bt=0,Kt=It.length;Bt<Kt;Bt++){let ce=It[Bt];bn(Pt,Tt,w,ce)}Ye&&F.render(w);for(let Bt=0,Kt=It.length;Bt<Kt;Bt++){let ce=It[Bt];bo(C,w,ce,ce.viewport)}}else Tt.length>0&&bn(Pt,Tt,w,O),Ye&&F.render(w),bo(C,w,O)}ct!==null&&z===0&&(Xt.updateMultisampleRenderTarget(ct),Xt.updateRenderTargetMipmap(ct)),$&&k.end(N),w.isScene===!0&&w.onAfterRender(N,w,O),Mt.resetDefaultState(),J=-1,Q=null,E.pop(),E.length>0?(T=E[E.length-1],Xt.setTextureUnits(T.state.textureUnits),Fe===!0&&nt.setGlobalState(N.clippingPlanes,T.state.camera)):T=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,V!==null&&V.renderEnd()};function ns(w,O,j,$){if(w.visible===!1)return;if(w.layers.test(O.layers)){if(w.isGroup)j=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(O);else if(w.isLight)T.pushLight(w),w.castShadow&&T.pushShadow(w);else if(w.isSprite){let Pt=O.isArrayCamera?Ge:te;if(!w.frustumCulled||w.intersectsFrustum(Pt)){$&&_e.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Ce);let Tt=ht.update(w),It=w.material;It.visible&&C.push(w,Tt,It,j,_e.z,null,O)}}else if(w.isMesh||w.isLine||w.isPoints){let Pt=O.isArrayCamera?Ge:te;if(!w.frustumCulled||w.intersectsFrustum(Pt)){let Tt=ht.update(w),It=w.material;if($&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),_e.copy(w.boundingSphere.center)):(Tt.boundingSphere===null&&Tt.computeBoundingSphere(),_e.copy(Tt.boundingSphere.center)),_e.applyMatrix4(w.matrixWorld).applyMatrix4(Ce)),Array.isArray(It)){let Bt=Tt.groups;for(let Kt=0,ce=Bt.length;Kt<ce;Kt++){let kt=Bt[Kt],he=It[kt.materialIndex];he&&he.visible&&C.push(w,Tt,he,j,_e.z,kt,O)}}else It.visible&&C.push(w,Tt,It,j,_e.z,null,O)}}}let Et=w.children;for(let Pt=0,Tt=Et.length;Pt<Tt;Pt++)ns(Et[Pt],O,j,$)}function bo(w,O,j,$){let{opaque:q,transmissive:Et,transparent:Pt}=w;T.setupLightsView(j),Fe===!0&&nt.setGlobalState(N.clippingPlanes,j),$&&bt.viewport(st.copy($)),q.length>0&&Ze(q,O,j),Et.length>0&&Ze(Et,O,j),Pt.length>0&&Ze(Pt,O,j),bt.buffers.depth.setTest(!0),bt.buffers.depth.setMask(!0),bt.buffers.color.setMask(!0),bt.setPolygonOffset(!1)}function bn(w,O,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[$.id]===void 0){let kt=$t.has("EXT_color_buffer_half_float")||$t.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[$.id]=new on(1,1,{generateMipmaps:!0,type:kt?Un:cn,minFilter:xs,samples:Math.max(4,ne.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:pe.workingColorSpace})}let Et=T.state.transmissionRenderTarget[$.id],Pt=$.viewport||st;Et.setSize(Pt.z*N.transmissionResolutionScale,Pt.w*N.transmissionResolutionScale);let Tt=N.getRenderTarget(),It=N.getActiveCubeFace(),Bt=N.getActiveMipmapLevel();N.setRenderTarget(Et),N.getClearColor(tt),mt=N.getClearAlpha(),mt<1&&N.setClearColor(16777215,.5),N.clear(),Ye&&F.render(j);let Kt=N.toneMapping;N.toneMapping=Qn;let ce=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),T.setupLightsView($),Fe===!0&&nt.setGlobalState(N.clippingPlanes,$),Ze(w,j,$),Xt.updateMultisampleRenderTarget(Et),Xt.updateRenderTargetMipmap(Et),$t.has("WEBGL_multisampled_render_to_texture")===!1){let kt=!1;for(let he=0,qe=O.length;he<qe;he++){let Te=O[he],{object:Ae,geometry:mi,material:Ft,group:ri}=Te;if(Ft.side===Sn&&Ae.layers.test($.layers)){let de=Ft.side;Ft.side=Gi,Ft.needsUpdate=!0,ti(Ae,j,$,mi,Ft,ri),Ft.side=de,Ft.needsUpdate=!0,kt=!0}}kt===!0&&(Xt.updateMultisampleRenderTarget(Et),Xt.updateRenderTargetMipmap(Et))}N.setRenderTarget(Tt,It,Bt),N.setClearColor(tt,mt),ce!==void 0&&($.viewport=ce),N.toneMapping=Kt}function Ze(w,O,j){let $=O.isScene===!0?O.overrideMaterial:null;for(let q=0,Et=w.length;q<Et;q++){let Pt=w[q],{object:Tt,geometry:It,group:Bt}=Pt,Kt=Pt.material;Kt.allowOverride===!0&&$!==null&&(Kt=$),Tt.layers.test(j.layers)&&ti(Tt,O,j,It,Kt,Bt)}}function ti(w,O,j,$,q,Et){V!==null&&q.isNodeMaterial&&V.setObject(w,q),w.onBeforeRender(N,O,j,$,q,Et),w.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),q.onBeforeRender(N,O,j,$,w,Et),q.transparent===!0&&q.side===Sn&&q.forceSinglePass===!1?(q.side=Gi,q.needsUpdate=!0,N.renderBufferDirect(j,O,$,q,w,Et),q.side=Hs,q.needsUpdate=!0,N.renderBufferDirect(j,O,$,q,w,Et),q.side=Sn):N.renderBufferDirect(j,O,$,q,w,Et),w.onAfterRender(N,O,j,$,q,Et)}function ei(w){let O=0;for(let j of w)j.texture!==null&&O++;return O}function Bn(w,O,j){O.isScene!==!0&&(O=pi);let $=zt.get(w),q=T.state.lights,Et=T.state.shadowsArray,Pt=q.state.version,Tt=ot.getParameters(w,q.state,Et,O,j,T.state.lightProbeGridArray),It=ot.getProgramCacheKey(Tt),Bt=$.programs;$.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?O.environment:null,$.fog=O.fog;let Kt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;$.envMap=R.get(w.envMap||$.environment,Kt),$.envMapRotation=$.environment!==null&&w.envMap===null?O.environmentRotation:w.envMapRotation,Bt===void 0&&(w.addEventListener("dispose",se),Bt=new Map,$.programs=Bt,$.programVariants=new Map);let ce=Bt.get(It);if(ce!==void 0){if($.currentProgram===ce&&$.lightsStateVersion===Pt)return wo(w,Tt),ce}else Tt.uniforms=ot.getUniforms(w),V!==null&&w.isNodeMaterial&&V.build(w,j,Tt),w.onBeforeCompile(Tt,N),ce=ot.acquireProgram(Tt,It),Bt.set(It,ce),$.uniforms=Tt.uniforms;let kt=$.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(kt.clippingPlanes=nt.uniform),wo(w,Tt),$.needsLights=Ss(w),$.lightsStateVersion=Pt,$.needsLights&&(kt.ambientLightColor.value=q.state.ambient,kt.lightProbe.value=q.state.probe,kt.sunLights.value=q.state.sun,kt.sunLightShadows.value=q.state.sunShadow,kt.directionalLights.value=q.state.directional,kt.directionalLightShadows.value=q.state.directionalShadow,kt.spotLights.value=q.state.spot,kt.spotLightShadows.value=q.state.spotShadow,kt.rectAreaLights.value=q.state.rectArea,kt.ltc_1.value=q.state.rectAreaLTC1,kt.ltc_2.value=q.state.rectAreaLTC2,kt.pointLights.value=q.state.point,kt.pointLightShadows.value=q.state.pointShadow,kt.hemisphereLights.value=q.state.hemi,kt.sunShadowMatrix.value=q.state.sunShadowMatrix,kt.sunShadowCascade.value=q.state.sunShadowCascade,kt.directionalShadowMatrix.value=q.state.directionalShadowMatrix,kt.spotLightMatrix.value=q.state.spotLightMatrix,kt.spotLightMap.value=q.state.spotLightMap,kt.pointShadowMatrix.value=q.state.pointShadowMatrix),$.numLightProbeGrids=ei(T.state.lightProbeGridArray),$.currentProgram=ce,$.uniformsList=null,ce}function Yi(w,O,j,$,q){let Et=zt.get(w),Pt=Et.currentProgram.id+","+$+","+q,Tt=Et.programVariants.get(Pt);return Tt===void 0?(Tt=Bn(w,O,j),Et.programVariants.set(Pt,Tt)):(Et.currentProgram=Tt,Et.uniformsList=null,Et.outputColorSpace=$,Et.toneMapping=q),Tt}function Ms(w){if(w.uniformsList===null){let O=w.currentProgram.getUniforms();w.uniformsList=yo.seqWithValue(O.seq,w.uniforms)}return w.uniformsList}function wo(w,O){let j=zt.get(w);j.outputColorSpace=O.outputColorSpace,j.batching=O.batching,j.batchingColor=O.batchingColor,j.instancing=O.instancing,j.instancingColor=O.instancingColor,j.instancingMorph=O.instancingMorph,j.skinning=O.skinning,j.morphTargets=O.morphTargets,j.morphNormals=O.morphNormals,j.morphColors=O.morphColors,j.morphTargetsCount=O.morphTargetsCount,j.numClippingPlanes=O.numClippingPlanes,j.numIntersection=O.numClipIntersection,j.vertexAlphas=O.vertexAlphas,j.vertexTangents=O.vertexTangents,j.toneMapping=O.toneMapping}function Eo(w,O,j,$,q){O.isScene!==!0&&(O=pi),Xt.resetTextureUnits();let Et=O.fog,Pt=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?O.environment:null,Tt=ct===null?N.outputColorSpace:ct.isXRRenderTarget===!0?ct.texture.colorSpace:pe.workingColorSpace,It=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,Bt=R.get($.envMap||Pt,It),Kt=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ce=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),kt=!!j.morphAttributes.position,he=!!j.morphAttributes.normal,qe=!!j.morphAttributes.color,Te=Qn;$.toneMapped&&(ct===null||ct.isXRRenderTarget===!0)&&(Te=N.toneMapping);let Ae=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,mi=Ae!==void 0?Ae.length:0,Ft=zt.get($),ri=T.state.lights;if(Fe===!0&&(ni===!0||w!==Q)){let Re=w===Q&&$.id===J;nt.setState($,w,Re)}let de=!1,ss=!1;$.version===Ft.__version?Ft.needsLights&&Ft.lightsStateVersion!==ri.state.version||q.isBatchedMesh&&Ft.batching===!1||!q.isBatchedMesh&&Ft.batching===!0||q.isBatchedMesh&&Ft.batchingColor===!0&&q._colorsTexture===null||q.isBatchedMesh&&Ft.batchingColor===!1&&q._colorsTexture!==null||q.isInstancedMesh&&Ft.instancing===!1||!q.isInstancedMesh&&Ft.instancing===!0||q.isSkinnedMesh&&Ft.skinning===!1||!q.isSkinnedMesh&&Ft.skinning===!0||q.isInstancedMesh&&Ft.instancingColor===!0&&q.instanceColor===null||q.isInstancedMesh&&Ft.instancingColor===!1&&q.instanceColor!==null||q.isInstancedMesh&&Ft.instancingMorph===!0&&q.morphTexture===null||q.isInstancedMesh&&Ft.instancingMorph===!1&&q.morphTexture!==null||Ft.envMap!==Bt||$.fog===!0&&Ft.fog!==Et||Ft.numClippingPlanes!==void 0&&(Ft.numClippingPlanes!==nt.numPlanes||Ft.numIntersection!==nt.numIntersection)||Ft.vertexAlphas!==Kt||Ft.vertexTangents!==ce||Ft.morphTargets!==kt||Ft.morphNormals!==he||Ft.morphColors!==qe||Ft.morphTargetsCount!==mi||Ft.numLightProbeGrids!==ei(T.state.lightProbeGridArray)?de=!0:(Ft.outputColorSpace!==Tt||Ft.toneMapping!==Te)&&(ss=!0):(de=!0,Ft.__version=$.version);let oi=Ft.currentProgram;(de===!0||ss===!0)&&(oi=ss===!0?Yi($,O,q,Tt,Te):Bn($,O,q),V&&$.isNodeMaterial&&V.onUpdateProgram($,oi,Ft));let Mr=!1,zn=!1,rs=!1,oe=oi.getUniforms(),Je=Ft.uniforms;if(bt.useProgram(oi.program)&&(Mr=!0,zn=!0,rs=!0),$.id!==J&&(J=$.id,zn=!0),Mr||Q!==w){bt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),oe.setValue(U,"projectionMatrix",w.projectionMatrix),oe.setValue(U,"viewMatrix",w.matrixWorldInverse);let ai=oe.map.cameraPosition;ai!==void 0&&ai.setValue(U,Mi.setFromMatrixPosition(w.matrixWorld)),ne.logarithmicDepthBuffer&&oe.setValue(U,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&oe.setValue(U,"isOrthographic",w.isOrthographicCamera===!0),Q!==w&&(Q=w,zn=!0,rs=!0)}if(Ft.needsLights&&(ri.state.sunShadowMap.length>0&&oe.setValue(U,"sunShadowMap",ri.state.sunShadowMap,Xt),ri.state.directionalShadowMap.length>0&&oe.setValue(U,"directionalShadowMap",ri.state.directionalShadowMap,Xt),ri.state.spotShadowMap.length>0&&oe.setValue(U,"spotShadowMap",ri.state.spotShadowMap,Xt),ri.state.pointShadowMap.length>0&&oe.setValue(U,"pointShadowMap",ri.state.pointShadowMap,Xt)),q.isSkinnedMesh){oe.setOptional(U,q,"bindMatrix"),oe.setOptional(U,q,"bindMatrixInverse");let Re=q.skeleton;Re&&(Re.boneTexture===null&&Re.computeBoneTexture(),oe.setValue(U,"boneTexture",Re.boneTexture,Xt))}q.isBatchedMesh&&(oe.setOptional(U,q,"batchingTexture"),oe.setValue(U,"batchingTexture",q._matricesTexture,Xt),oe.setOptional(U,q,"batchingIdTexture"),oe.setValue(U,"batchingIdTexture",q._indirectTexture,Xt),oe.setOptional(U,q,"batchingColorTexture"),q._colorsTexture!==null&&oe.setValue(U,"batchingColorTexture",q._colorsTexture,Xt));let ki=j.morphAttributes;if((ki.position!==void 0||ki.normal!==void 0||ki.color!==void 0)&&rt.update(q,j,oi),(zn||Ft.receiveShadow!==q.receiveShadow)&&(Ft.receiveShadow=q.receiveShadow,oe.setValue(U,"receiveShadow",q.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&O.environment!==null&&(Je.envMapIntensity.value=O.environmentIntensity),Je.dfgLUT!==void 0&&(Je.dfgLUT.value=J1()),zn){if(oe.setValue(U,"toneMappingExposure",N.toneMappingExposure),Ft.needsLights&&vr(Je,rs),Et&&$.fog===!0&&_t.refreshFogUniforms(Je,Et),_t.refreshMaterialUniforms(Je,$,St,At,T.state.transmissionRenderTarget[w.id]),Ft.needsLights&&Ft.numLightProbeGrids>0){let Re=S,ai=0;for(let Li of T.state.lightProbeGridArray)Li.texture!==null&&(Re.textures[ai]=Li.texture,Re.min[ai]=Li.boundingBox.min,Re.max[ai]=Li.boundingBox.max,Re.resolution[ai]=Li.resolution,ai++);for(let Li in Re)Re[Li].length=ai;Je.probesSH.value=Re.textures,Je.probesMin.value=Re.min,Je.probesMax.value=Re.max,Je.probesResolution.value=Re.resolution}yo.upload(U,Ms(Ft),Je,Xt)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(yo.upload(U,Ms(Ft),Je,Xt),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&oe.setValue(U,"center",q.center),oe.setValue(U,"modelViewMatrix",q.modelViewMatrix),oe.setValue(U,"normalMatrix",q.normalMatrix),oe.setValue(U,"modelMatrix",q.matrixWorld),$.uniformsGroups!==void 0){let Re=$.uniformsGroups;for(let ai=0,Li=Re.length;ai<Li;ai++){let La=Re[ai];Ht.update(La,oi),Ht.bind(La,oi)}}return oi}function vr(w,O){w.ambientLightColor.needsUpdate=O,w.lightProbe.needsUpdate=O,w.sunLights.needsUpdate=O,w.sunLightShadows.needsUpdate=O,w.directionalLights.needsUpdate=O,w.directionalLightShadows.needsUpdate=O,w.pointLights.needsUpdate=O,w.pointLightShadows.needsUpdate=O,w.spotLights.needsUpdate=O,w.spotLightShadows.needsUpdate=O,w.rectAreaLights.needsUpdate=O,w.hemisphereLights.needsUpdate=O}function Ss(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return ct},this.setRenderTargetTextures=function(w,O,j){let $=zt.get(w);$.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),zt.get(w.texture).__webglTexture=O,zt.get(w.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,O){let j=zt.get(w);j.__webglFramebuffer=O,j.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(w,O=0,j=0){ct=w,Z=O,z=j;let $=null,q=!1,Et=!1;if(w){let Tt=zt.get(w);if(Tt.__useDefaultFramebuffer!==void 0){bt.bindFramebuffer(U.FRAMEBUFFER,Tt.__webglFramebuffer),st.copy(w.viewport),dt.copy(w.scissor),ut=w.scissorTest,bt.viewport(st),bt.scissor(dt),bt.setScissorTest(ut),J=-1;return}else if(Tt.__webglFramebuffer===void 0)Xt.setupRenderTarget(w);else if(Tt.__hasExternalTextures)Xt.rebindTextures(w,zt.get(w.texture).__webglTexture,zt.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let Kt=w.depthTexture;if(Tt.__boundDepthTexture!==Kt){if(Kt!==null&&zt.has(Kt)&&(w.width!==Kt.image.width||w.height!==Kt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xt.setupDepthRenderbuffer(w)}}let It=w.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Et=!0);let Bt=zt.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Bt[O])?$=Bt[O][j]:$=Bt[O],q=!0):w.samples>0&&Xt.useMultisampledRTT(w)===!1?$=zt.get(w).__webglMultisampledFramebuffer:Array.isArray(Bt)?$=Bt[j]:$=Bt,st.copy(w.viewport),dt.copy(w.scissor),ut=w.scissorTest}else st.copy(Vt).multiplyScalar(St).floor(),dt.copy(le).multiplyScalar(St).floor(),ut=re;if(j!==0&&($=G),bt.bindFramebuffer(U.FRAMEBUFFER,$)&&bt.drawBuffers(w,$),bt.viewport(st),bt.scissor(dt),bt.setScissorTest(ut),q){let Tt=zt.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+O,Tt.__webglTexture,j)}else if(Et){let Tt=O;for(let It=0;It<w.textures.length;It++){let Bt=zt.get(w.textures[It]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+It,Bt.__webglTexture,j,Tt)}}else if(w!==null&&j!==0){let Tt=zt.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Tt.__webglTexture,j)}J=-1};function yr(w){let O=zt.get(w);return(O.__readFormat!==w.format||O.__readType!==w.type)&&(O.__readFormat=w.format,O.__readType=w.type,O.__formatReadable=ne.textureFormatReadable(w.format),O.__typeReadable=ne.textureTypeReadable(w.type)),O}this.readRenderTargetPixels=function(w,O,j,$,q,Et,Pt,Tt=0){if(!(w&&w.isWebGLRenderTarget)){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){bt.bindFramebuffer(U.FRAMEBUFFER,It);try{let Bt=w.textures[Tt],Kt=Bt.format,ce=Bt.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Tt);let kt=yr(Bt);if(kt.__formatReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(kt.__typeReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=w.width-$&&j>=0&&j<=w.height-q&&U.readPixels(O,j,$,q,gt.convert(Kt),gt.convert(ce),Et)}finally{let Bt=ct!==null?zt.get(ct).__webglFramebuffer:null;bt.bindFramebuffer(U.FRAMEBUFFER,Bt)}}},this.readRenderTargetPixelsAsync=async function(w,O,j,$,q,Et,Pt,Tt=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(O>=0&&O<=w.width-$&&j>=0&&j<=w.height-q){bt.bindFramebuffer(U.FRAMEBUFFER,It);let Bt=w.textures[Tt],Kt=Bt.format,ce=Bt.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Tt);let kt=yr(Bt);if(kt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(kt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let he=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,he),U.bufferData(U.PIXEL_PACK_BUFFER,Et.byteLength,U.STREAM_READ),U.readPixels(O,j,$,q,gt.convert(Kt),gt.convert(ce),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let qe=ct!==null?zt.get(ct).__webglFramebuffer:null;bt.bindFramebuffer(U.FRAMEBUFFER,qe);let Te=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await Vg(U,Te,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,he),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,Et),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(he),U.deleteSync(Te),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,O=null,j=0){let $=Math.pow(2,-j),q=Math.floor(w.image.width*$),Et=Math.floor(w.image.height*$),Pt=O!==null?O.x:0,Tt=O!==null?O.y:0;Xt.setTexture2D(w,0),U.copyTexSubImage2D(U.TEXTURE_2D,j,0,0,Pt,Tt,q,Et),bt.unbindTexture()},this.copyTextureToTexture=function(w,O,j=null,$=null,q=0,Et=0){let Pt,Tt,It,Bt,Kt,ce,kt,he,qe,Te=w.isCompressedTexture?w.mipmaps[Et]:w.image;if(j!==null)Pt=j.max.x-j.min.x,Tt=j.max.y-j.min.y,It=j.isBox3?j.max.z-j.min.z:1,Bt=j.min.x,Kt=j.min.y,ce=j.isBox3?j.min.z:0;else{let oe=Math.pow(2,-q);Pt=Math.floor(Te.width*oe),Tt=Math.floor(Te.height*oe),w.isDataArrayTexture?It=Te.depth:w.isData3DTexture?It=Math.floor(Te.depth*oe):It=1,Bt=0,Kt=0,ce=0}$!==null?(kt=$.x,he=$.y,qe=$.z):(kt=0,he=0,qe=0);let Ae=gt.convert(O.format),mi=gt.convert(O.type),Ft;O.isData3DTexture?(Xt.setTexture3D(O,0),Ft=U.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(Xt.setTexture2DArray(O,0),Ft=U.TEXTURE_2D_ARRAY):(Xt.setTexture2D(O,0),Ft=U.TEXTURE_2D),bt.activeTexture(U.TEXTURE0),bt.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,O.flipY),bt.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),bt.pixelStorei(U.UNPACK_ALIGNMENT,O.unpackAlignment);let ri=bt.getParameter(U.UNPACK_ROW_LENGTH),de=bt.getParameter(U.UNPACK_IMAGE_HEIGHT),ss=bt.getParameter(U.UNPACK_SKIP_PIXELS),oi=bt.getParameter(U.UNPACK_SKIP_ROWS),Mr=bt.getParameter(U.UNPACK_SKIP_IMAGES);bt.pixelStorei(U.UNPACK_ROW_LENGTH,Te.width),bt.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Te.height),bt.pixelStorei(U.UNPACK_SKIP_PIXELS,Bt),bt.pixelStorei(U.UNPACK_SKIP_ROWS,Kt),bt.pixelStorei(U.UNPACK_SKIP_IMAGES,ce);let zn=w.isDataArrayTexture||w.isData3DTexture,rs=O.isDataArrayTexture||O.isData3DTexture;if(w.isDepthTexture){let oe=zt.get(w),Je=zt.get(O),ki=zt.get(oe.__renderTarget),Re=zt.get(Je.__renderTarget);bt.bindFramebuffer(U.READ_FRAMEBUFFER,ki.__webglFramebuffer),bt.bindFramebuffer(U.DRAW_FRAMEBUFFER,Re.__webglFramebuffer);for(let ai=0;ai<It;ai++)zn&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,zt.get(w).__webglTexture,q,ce+ai),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,zt.get(O).__webglTexture,Et,qe+ai)),U.blitFramebuffer(Bt,Kt,Bt+Pt,Kt+Tt,kt,he,kt+Pt,he+Tt,U.DEPTH_BUFFER_BIT,U.NEAREST);bt.bindFramebuffer(U.READ_FRAMEBUFFER,null),bt.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(q!==0||w.isRenderTargetTexture||zt.has(w)){let oe=zt.get(w),Je=zt.get(O);bt.bindFramebuffer(U.READ_FRAMEBUFFER,D),bt.bindFramebuffer(U.DRAW_FRAMEBUFFER,H);for(let ki=0;ki<It;ki++)zn?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,oe.__webglTexture,q,ce+ki):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,oe.__webglTexture,q),rs?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Je.__webglTexture,Et,qe+ki):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Je.__webglTexture,Et),q!==0?U.blitFramebuffer(Bt,Kt,Bt+Pt,Kt+Tt,kt,he,kt+Pt,he+Tt,U.COLOR_BUFFER_BIT,U.NEAREST):rs?U.copyTexSubImage3D(Ft,Et,kt,he,qe+ki,Bt,Kt,Pt,Tt):U.copyTexSubImage2D(Ft,Et,kt,he,Bt,Kt,Pt,Tt);bt.bindFramebuffer(U.READ_FRAMEBUFFER,null),bt.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else rs?w.isDataTexture||w.isData3DTexture?U.texSubImage3D(Ft,Et,kt,he,qe,Pt,Tt,It,Ae,mi,Te.data):O.isCompressedArrayTexture?U.compressedTexSubImage3D(Ft,Et,kt,he,qe,Pt,Tt,It,Ae,Te.data):U.texSubImage3D(Ft,Et,kt,he,qe,Pt,Tt,It,Ae,mi,Te):w.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,Et,kt,he,Pt,Tt,Ae,mi,Te.data):w.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,Et,kt,he,Te.width,Te.height,Ae,Te.data):U.texSubImage2D(U.TEXTURE_2D,Et,kt,he,Pt,Tt,Ae,mi,Te);bt.pixelStorei(U.UNPACK_ROW_LENGTH,ri),bt.pixelStorei(U.UNPACK_IMAGE_HEIGHT,de),bt.pixelStorei(U.UNPACK_SKIP_PIXELS,ss),bt.pixelStorei(U.UNPACK_SKIP_ROWS,oi),bt.pixelStorei(U.UNPACK_SKIP_IMAGES,Mr),Et===0&&O.generateMipmaps===!0&&O.mipmapsAutoUpdate===!0&&U.generateMipmap(Ft),bt.unbindTexture()},this.initRenderTarget=function(w){zt.get(w).__webglFramebuffer===void 0&&Xt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Xt.setTextureCube(w,0):w.isData3DTexture?Xt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Xt.setTexture2DArray(w,0):Xt.setTexture2D(w,0),bt.unbindTexture()},this.resetState=function(){Z=0,z=0,ct=null,bt.reset(),Mt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return yn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=pe._getDrawingBufferColorSpace(t),e.unpackColorSpace=pe._getUnpackColorSpace()}};function hn(n,t,e,i){return new po({glslVersion:Ea,vertexShader:n,fragmentShader:t,uniforms:e,transparent:!0,depthTest:i,depthWrite:i,side:Sn})}var On=`
precision highp float;
precision highp int;
uniform mat4 view;
uniform mat4 projection;
uniform vec3 eye;
uniform vec3 up;
uniform vec3 right;
uniform float pixel;   // metres per CSS pixel at a depth of one metre
uniform float ratio;   // device pixels per CSS pixel
`,nf=`
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
`,T0=`${On}${nf}
uniform highp sampler2D nodes;
uniform int columns;
uniform float least;   // least width in CSS pixels
in vec4 look;          // radius [m], distance along the rope [m], has a node before, after
in vec3 tint;
out float across;
out float halfWidth;   // CSS pixels
out float value;
out float along;
out vec3 side;
out vec3 sight;
out vec3 ropeTint;
out float behind;
vec4 node(int i) { return texelFetch(nodes, ivec2(i % columns, i / columns), 0); }
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec4 here = node(i);
  vec3 before = look.z > 0.5 ? node(i - 1).xyz : here.xyz;
  vec3 after = look.w > 0.5 ? node(i + 1).xyz : here.xyz;
  sight = normalize(eye - here.xyz);
  side = sideways(before, here.xyz, after, sight);
  float depth = -(view * vec4(here.xyz, 1.0)).z;
  behind = depth > 0.0 ? 0.0 : 1.0;
  float perPixel = pixel * max(depth, 1e-3);
  halfWidth = max(look.x / perPixel, 0.5 * least);
  value = here.w;
  along = look.y / max(look.x, 1e-9);
  ropeTint = tint;
  vec3 place = here.xyz + side * across * (halfWidth + 1.0) * perPixel;
  gl_Position = projection * view * vec4(place, 1.0);
}
`,A0=`${On}
uniform sampler2D map;
uniform vec2 range;    // values of the map's two ends
uniform bool plain;
uniform float night;   // 1 in the dark theme
in float across;
in float halfWidth;
in float value;
in float along;
in vec3 side;
in vec3 sight;
in vec3 ropeTint;
in float behind;       // > 0: a part of a segment that ends behind the eye
out vec4 colour;
void main() {
  if (behind > 0.0) discard;
  float w = across * (halfWidth + 1.0);
  float cover = clamp(halfWidth + 0.5 - abs(w), 0.0, 1.0);
  if (cover <= 0.0) discard;
  float u = clamp(w / halfWidth, -1.0, 1.0);
  float z = sqrt(1.0 - u * u);
  vec3 normal = normalize(side) * u + normalize(sight) * z;
  float part = (value - range.x) / max(range.y - range.x, 1e-30);
  vec3 base = plain ? ropeTint : texture(map, vec2(clamp(part, 0.002, 0.998), 0.5)).rgb;
  // Strands, seen when the rope is wide enough: ridges that wind around it.
  float lay = sin(along * 1.7 + asin(u) * 2.0);
  float near = smoothstep(5.0, 12.0, halfWidth);
  base *= 1.0 - 0.22 * near * smoothstep(0.35, 1.0, lay);
  vec3 key = normalize(up * 0.85 + normalize(sight) * 0.75 + right * 0.35);
  float light = 0.62 + 0.4 * max(dot(normal, key), 0.0) + 0.08 * dot(normal, up);
  float glint = pow(max(dot(reflect(-key, normal), normalize(sight)), 0.0), 24.0);
  float rim = mix(0.8, 1.0, smoothstep(0.0, 0.55, z));
  vec3 lit = base * light * rim * mix(1.0, 1.06, night) + 0.14 * glint;
  colour = vec4(lit, cover);
}
`,R0=`${On}${nf}
uniform highp sampler2D nodes;
uniform int columns;
uniform float least;
uniform float height;  // of the ground along up [m]
in vec4 look;
out float across;
out float halfWidth;
out float far;
vec3 flat_(int i) {
  vec3 p = texelFetch(nodes, ivec2(i % columns, i / columns), 0).xyz;
  return p - up * (dot(p, up) - height);
}
void main() {
  int i = gl_VertexID >> 1;
  across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec3 here = flat_(i);
  vec3 before = look.z > 0.5 ? flat_(i - 1) : here;
  vec3 after = look.w > 0.5 ? flat_(i + 1) : here;
  vec3 side = sideways(before, here, after, up);
  float perPixel = pixel * -(view * vec4(here, 1.0)).z;
  halfWidth = max(look.x / perPixel, 0.6 * least) + 1.0;
  gl_Position = projection * view * vec4(here + side * across * halfWidth * perPixel, 1.0);
}
`,C0=`${On}
uniform vec4 ink;
in float across;
in float halfWidth;
out vec4 colour;
void main() {
  float edge = 1.0 - smoothstep(0.25, 1.0, abs(across));
  colour = vec4(ink.rgb, ink.a * edge);
}
`,P0=`${On}${nf}
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
`,I0=`
precision highp float;
in float across;
in float age;
in vec3 colourOf;
out vec4 colour;
void main() {
  float cover = clamp(1.8 - 2.0 * abs(across), 0.0, 1.0);
  colour = vec4(colourOf, 0.75 * cover * (1.0 - age) * (1.0 - age));
}
`,L0=`${On}
in vec3 position;
in vec4 ink;           // colour, kind: 0 ball, 1 plate, 2 ring
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
`,N0=`${On}
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
    vec2 corner = abs(at) - vec2(radius * 0.62);
    float away = length(max(corner, 0.0)) + min(max(corner.x, corner.y), 0.0) - radius * 0.22;
    float cover = clamp(0.5 - away, 0.0, 1.0);
    float line = smoothstep(-2.6, -1.4, away);
    colour = vec4(mix(colourOf.rgb * (1.04 + 0.1 * at.y / radius), colourOf.rgb * 0.72, line), cover);
  } else {
    float cover = clamp(radius + 0.5 - length(at), 0.0, 1.0);
    vec2 n = at / radius;
    float z = sqrt(max(0.0, 1.0 - dot(n, n)));
    float light = 0.62 + 0.42 * max(dot(vec3(n, z), normalize(vec3(0.35, 0.8, 0.7))), 0.0);
    float glint = pow(max(dot(vec3(n, z), normalize(vec3(0.2, 0.5, 0.9))), 0.0), 30.0);
    colour = vec4(colourOf.rgb * light + 0.18 * glint, cover);
  }
  if (colour.a <= 0.0) discard;
}
`,D0=`${On}
uniform highp sampler2D nodes;
uniform int columns;
uniform float dot_;    // CSS pixels
void main() {
  vec3 here = texelFetch(nodes, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0).xyz;
  vec4 seen = view * vec4(here, 1.0);
  seen.z += 0.02 * -seen.z;
  gl_Position = projection * seen;
  gl_PointSize = dot_ * ratio;
}
`,F0=`
precision highp float;
uniform vec3 ink;
out vec4 colour;
void main() {
  float away = length(gl_PointCoord * 2.0 - 1.0);
  float cover = 1.0 - smoothstep(0.7, 1.0, away);
  if (cover <= 0.0) discard;
  colour = vec4(ink, cover);
}
`,U0=`${On}
uniform vec3 center;   // on the ground, on a crossing of lines
uniform vec3 first;
uniform vec3 second;
uniform float spacing;
uniform int half_;     // lines on each side of the middle
in vec3 position;      // line, end, side
out vec2 place;        // in the plane, 1 at the rim
out float across;
void main() {
  bool turned = position.x > float(2 * half_) + 0.5;
  float line = position.x - (turned ? float(2 * half_ + 1) : 0.0) - float(half_);
  vec3 along = turned ? second : first;
  vec3 over = turned ? first : second;
  vec3 here = center + (over * line + along * position.y * float(half_)) * spacing;
  place = vec2(line / float(half_), position.y);
  across = position.z;
  float depth = max(-(view * vec4(here, 1.0)).z, 0.02);
  vec3 flat_ = cross(along, normalize(eye - here));
  here += normalize(flat_ + 1e-9) * position.z * 1.1 * pixel * depth;
  gl_Position = projection * view * vec4(here, 1.0);
}
`,O0=`
precision highp float;
uniform vec4 ink;
in vec2 place;
in float across;
out vec4 colour;
void main() {
  float fade = 1.0 - smoothstep(0.25, 1.0, length(place));
  colour = vec4(ink.rgb, ink.a * fade * (1.0 - smoothstep(0.3, 1.0, abs(across))));
}
`,k0=`${On}
uniform vec3 center;
uniform vec3 first;
uniform vec3 second;
uniform float radius;
in vec3 position;
out vec2 place;
void main() {
  place = position.xy;
  vec3 here = center + (first * position.x + second * position.y) * radius;
  gl_Position = projection * view * vec4(here, 1.0);
}
`,B0=`
precision highp float;
uniform vec4 ink;
in vec2 place;
out vec4 colour;
void main() {
  colour = vec4(ink.rgb, ink.a * (1.0 - smoothstep(0.2, 1.0, length(place))));
}
`,z0=`${On}
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
`,V0=`
precision highp float;
in vec3 colourOf;
in float away;
in float halfWidth;
out vec4 colour;
void main() {
  colour = vec4(colourOf, clamp(halfWidth + 0.5 - abs(away), 0.0, 1.0));
}
`;var sf=256,rf=7,H0=[0,1,2,1,3,2,4,5,6],wh=class{constructor(t){let e=new ii;for(let[s,r]of[["position",3],["line",3],["ink",4],["edge",1]]){let o=new $e(new Float32Array(r*rf*sf),r);o.setUsage(wa),e.setAttribute(s,o)}let i=[];for(let s=0;s<sf;s++)i.push(...H0.map(r=>r+rf*s));e.setIndex(i),this.mesh=new fi(e,hn(z0,V0,t,!1)),this.mesh.frustumCulled=!1,this.mesh.renderOrder=2.5}update(t,e){let i=Math.min(sf,t.length);if(this.mesh.visible=i>0,!i)return;let s=this.mesh.geometry,[r,o,a,c]=["position","line","ink","edge"].map(l=>s.getAttribute(l));for(let l=0;l<i;l++){let{from:h,to:u,colour:d,pixels:f,head:g}=t[l],y=[u[0]-h[0],u[1]-h[1],u[2]-h[2]],m=Math.hypot(y[0],y[1],y[2]),p=g&&m>0?Math.min(.5,5.5*f*e/m):0,v=f/2,A=g?2.2*f:0;[[0,v,-1],[0,v,1],[1-p,v,-1],[1-p,v,1],[1-p,A,-1],[1-p,A,1],[1,0,0]].forEach(([C,T,x],E)=>{let k=rf*l+E;r.setXYZ(k,h[0]+C*y[0],h[1]+C*y[1],h[2]+C*y[2]),o.setXYZ(k,y[0],y[1],y[2]),a.setXYZW(k,d[0],d[1],d[2],x*(T&&T+1)),c.setX(k,T)})}r.needsUpdate=o.needsUpdate=a.needsUpdate=c.needsUpdate=!0,s.setDrawRange(0,H0.length*i)}};var of=14,Eh=class{constructor(t){this.uniforms={center:{value:new K},first:{value:new K(1,0,0)},second:{value:new K(0,1,0)},spacing:{value:1},radius:{value:1},half_:{value:of}},this.gridInk={value:new Ie(0,0,0,.3)},this.floorInk={value:new Ie(0,0,0,.3)};let e={...t,...this.uniforms};this.grid=new fi(K1(),hn(U0,O0,{...e,ink:this.gridInk},!1));let i=new ii,s=new Float32Array([-1,-1,0,1,-1,0,-1,1,0,1,1,0]);i.setAttribute("position",new $e(s,3)),i.setIndex([0,1,2,1,3,2]),this.disc=new fi(i,hn(k0,B0,{...e,ink:this.floorInk},!1)),this.disc.renderOrder=-4,this.grid.renderOrder=-3,this.disc.frustumCulled=this.grid.frustumCulled=!1}setTheme(t){this.gridInk.value.set(...t.grid,.9),this.floorInk.value.set(...t.ground,.95)}update(t,e){this.grid.visible=t!==null,this.disc.visible=t!==null&&t.solid,t&&(this.uniforms.center.value.set(...t.center),this.uniforms.first.value.set(...e.first),this.uniforms.second.value.set(...e.second),this.uniforms.spacing.value=t.spacing,this.uniforms.radius.value=t.spacing*of)}};function K1(){let n=[],t=[];for(let i=0;i<2*(2*of+1);i++){let s=n.length/3;for(let[r,o]of[[-1,-1],[-1,1],[1,-1],[1,1]])n.push(i,r,o);t.push(s,s+1,s+2,s+1,s+3,s+2)}let e=new ii;return e.setAttribute("position",new $e(new Float32Array(n),3)),e.setIndex(t),e}var j1={round:0,square:1,ring:2},Th=class{constructor(t){this.room=0,this.points=new cr(void 0,hn(L0,N0,t,!0)),this.points.frustumCulled=!1,this.points.renderOrder=3,this.grow(32)}grow(t){this.room=t,this.points.geometry.dispose();let e=new ii;for(let[i,s]of[["position",3],["ink",4],["sizes",2]]){let r=new $e(new Float32Array(s*t),s);r.setUsage(wa),e.setAttribute(i,r)}this.points.geometry=e}update(t){t.length>this.room&&this.grow(2*t.length);let e=this.points.geometry,[i,s,r]=["position","ink","sizes"].map(o=>e.getAttribute(o));t.forEach((o,a)=>{i.setXYZ(a,o.x,o.y,o.z);let[c,l,h]=o.colour;s.setXYZW(a,c,l,h,j1[o.kind]),r.setXY(a,o.size,o.pixels)}),i.needsUpdate=s.needsUpdate=r.needsUpdate=!0,e.setDrawRange(0,t.length),this.points.visible=t.length>0}};var Ah=class{constructor(t){this.uniforms={nodes:{value:null},columns:{value:1},least:{value:4},map:{value:tE()},range:{value:new xe(0,1)},plain:{value:!1},night:{value:0},height:{value:0}},this.shadowInk={value:new Ie(0,0,0,.2)},this.dotInk={value:new K(0,0,0)};let e={...t,...this.uniforms};this.ropes=new fi(void 0,hn(T0,A0,e,!0)),this.shadow=new fi(void 0,hn(R0,C0,{...e,ink:this.shadowInk},!1)),this.dots=new cr(void 0,hn(D0,F0,{...e,ink:this.dotInk,dot_:{value:5}},!0)),this.shadow.renderOrder=-2,this.ropes.renderOrder=1,this.dots.renderOrder=2;for(let i of[this.ropes,this.shadow,this.dots])i.frustumCulled=!1;this.texture=null}setShape(t){let e=Q1(t);this.ropes.geometry.dispose(),this.ropes.geometry=e,this.shadow.geometry=e;let i=new ii;i.setIndex(new $e(Uint32Array.from({length:t.nodes},(s,r)=>r),1)),this.dots.geometry.dispose(),this.dots.geometry=i}use(t){if(this.texture?.image.data===t)return;this.texture?.dispose();let[e,i]=Al(t.length/4);this.texture=new gs(t,e,i,Xi,Wi),this.texture.internalFormat="RGBA32F",this.uniforms.nodes.value=this.texture,this.uniforms.columns.value=e,this.texture.needsUpdate=!0}dispose(){this.texture?.dispose(),this.ropes.geometry.dispose(),this.dots.geometry.dispose()}};function Q1(n){let t=new Float32Array(8*n.nodes),e=new Float32Array(6*n.nodes),i=[];for(let r of n.ropes)for(let o=0;o<r.count;o++){let a=r.first+o,c=o>0,l=o<r.count-1;for(let h of[2*a,2*a+1])t.set([r.radius,o*r.spacing,Number(c),Number(l)],4*h),e.set(r.colour,3*h);if(l){let h=2*a;i.push(h,h+1,h+2,h+1,h+3,h+2)}}let s=new ii;return s.setAttribute("look",new $e(t,4)),s.setAttribute("tint",new $e(e,3)),s.setIndex(new $e(new Uint32Array(i),1)),s}function tE(){let n=new Uint8Array(4*256);Ir().forEach((e,i)=>n.set([...e.map(s=>Math.round(255*s)),255],4*i));let t=new gs(n,256,1);return t.minFilter=Ri,t.magFilter=Ri,t.needsUpdate=!0,t}var Rh=class{constructor(t){this.uniforms={points:{value:null},columns:{value:360},head:{value:0}},this.mesh=new fi(void 0,hn(P0,I0,{...t,...this.uniforms},!1)),this.mesh.frustumCulled=!1,this.trails=null,this.version=-1}update(t){if(this.mesh.visible=t!==null&&!t.empty,!t||(t!==this.trails&&this.rebuild(t),t.version===this.version))return;this.version=t.version,this.uniforms.head.value=t.head;let e=this.uniforms.points.value;e&&(e.needsUpdate=!0)}rebuild(t){this.trails=t,this.version=-1;let e=t.nodes.length;this.uniforms.points.value?.dispose();let i=new gs(t.points,360,e,Xi,Wi);i.internalFormat="RGBA32F",this.uniforms.points.value=i;let s=new Float32Array(6*360*e),r=[];for(let a=0;a<e;a++)for(let c=0;c<360;c++){let l=2*(a*360+c);s.set([...t.colours[a],...t.colours[a]],3*l),c<359&&r.push(l,l+1,l+2,l+1,l+3,l+2)}let o=new ii;o.setAttribute("tint",new $e(s,3)),o.setIndex(r),this.mesh.geometry.dispose(),this.mesh.geometry=o}};var Ch=class{constructor(t){let e=t.getContext("webgl2",{antialias:!1,alpha:!1,powerPreference:"high-performance"});if(!e)throw new Error("no WebGL2");this.name="webgl",this.canvas=t,this.three=new Mh({canvas:t,context:e,antialias:!1}),this.three.outputColorSpace=Fs,this.shared={view:{value:new Ue},projection:{value:new Ue},eye:{value:new K},up:{value:new K},right:{value:new K},pixel:{value:.001},ratio:{value:1}},this.scene=new aa,this.scene.matrixWorldAutoUpdate=!1,this.camera=new hr,this.ribbons=new Ah(this.shared),this.floor=new Eh(this.shared),this.markers=new Th(this.shared),this.arrows=new wh(this.shared),this.trails=new Rh(this.shared),this.scene.add(this.floor.disc,this.floor.grid,this.ribbons.shadow,this.trails.mesh,this.ribbons.ropes,this.ribbons.dots,this.markers.points,this.arrows.mesh)}setShape(t){this.ribbons.setShape(t)}setTheme(t){let e=new me().setRGB(...t.background,Fs);this.three.setClearColor(e,1),this.floor.setTheme(t),this.ribbons.shadowInk.value.set(...t.shadow,t.dark?.85:.3),this.ribbons.dotInk.value.set(...t.node),this.ribbons.uniforms.night.value=t.dark?1:0}resize(t,e,i){this.three.setPixelRatio(i),this.three.setSize(t,e,!1),this.shared.ratio.value=i}draw(t){let{camera:e}=t;this.shared.view.value.fromArray(e.view),this.shared.projection.value.fromArray(e.projection),this.shared.eye.value.set(...e.eye),this.shared.up.value.set(...e.up),this.shared.right.value.set(...e.right),this.shared.pixel.value=1/e.focal,this.ribbons.use(t.nodes),t.moved&&this.ribbons.texture&&(this.ribbons.texture.needsUpdate=!0);let i=this.ribbons.uniforms;i.range.value.set(t.range.low,t.range.high),i.plain.value=t.plain,i.least.value=t.pixels,i.height.value=t.ground?.height??0,this.ribbons.shadow.visible=t.ground!==null,this.ribbons.dots.visible=t.dots,this.floor.update(t.ground,e),this.markers.update(t.markers),this.arrows.update(t.arrows,e.pose.distance/e.focal),this.trails.update(t.trails),this.three.render(this.scene,this.camera)}clear(){this.three.clear()}dispose(){this.ribbons.dispose(),this.three.dispose()}};function W0(n){if(new URLSearchParams(location.search).get("renderer")!=="canvas")try{return new Ch(n)}catch(e){console.info("Canvas 2D is used:",e);let i=n.cloneNode();return n.replaceWith(i),new Zo(i)}return new Zo(n)}var Ph=class{constructor(){this.listeners=new Map}on(t,e){let i=this.listeners.get(t)??[];i.push(e),this.listeners.set(t,i)}emit(t,e){for(let i of this.listeners.get(t)??[])i(e)}};var Ih=class extends Ph{constructor(t){super(),this.source=t,this.hello=null,this.layout=null,this.parameters=[],this.presets=[],this.status=null,this.stability=[],this.broken=null,this.frame=null,this.frames=0,this.connection="connecting",this.lastId=0,this.pendingFrame=-1,this.resting=!1,this.waiting=new Map}open(){this.source.open({message:t=>this.take(t),frame:t=>this.takeFrame(t),state:(t,e)=>{if(this.connection=t,t!=="open"){let i={type:"error",text:"The server is not there."};for(let{reject:s}of this.waiting.values())s(i);this.waiting.clear()}this.emit("connection",{state:t,text:e})}})}can(t){return this.hello?.can.includes(t)??!1}send(t){this.can(t.type)&&this.source.send(t)}ask(t){let e=++this.lastId;return new Promise((i,s)=>{if(!this.can(t.type)){s({type:"error",text:`${t.type}: cannot be done here`});return}this.waiting.set(e,{resolve:i,reject:s}),this.source.send({...t,id:e})})}async tell(t){try{return await this.ask(t),!0}catch(e){return this.emit("error",e),!1}}take(t){switch(t.type){case"hello":this.hello=t;break;case"layout":t.layout!==this.layout?.layout&&(this.frame=null),this.layout=t;break;case"parameters":this.parameters=t.parameters,this.emit("parameters",this.parameters);return;case"presets":this.presets=t.presets,this.emit("presets",this.presets);return;case"status":this.status=t,!t.broken&&this.broken&&(this.broken=null,this.emit("broken",null));break;case"stability":this.stability=t.variants,this.emit("stability",this.stability);return;case"broken":this.broken=t;break;case"done":case"error":this.answer(t);return}this.emit(t.type,t)}answer(t){let e=this.waiting.get(t.id);this.waiting.delete(t.id),t.type==="done"?e?.resolve(t):e?e.reject(t):this.emit("error",t)}takeFrame(t){if(this.pendingFrame=Nf(t),!this.layout||Oa(t)!==this.layout.layout){this.acknowledge();return}let e=this.frame;this.frame=Nr(t,this.layout),this.frames++,this.emit("frame",this.frame),e&&Df(e)}acknowledge(){this.resting=!this.resting,!(this.pendingFrame<0||this.resting)&&(this.source.used(this.pendingFrame),this.pendingFrame=-1)}};function X0(n){let t=atob(n.trim()),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e}async function $0(n){let t=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(t).arrayBuffer())}function q0({columns:n,low:t,step:e,order:i,planes:s},r,o){let a=r*n;if(o.length!==a*s)throw new Error("the recording is damaged");let c=new Int32Array(a);for(let l=0;l<n;l++){let h=0,u=0;for(let d=l*r;d<(l+1)*r;d++){let f=o[d];for(let y=1;y<s;y++)f|=o[y*a+d]<<8*y;let g=f>>>1^-(f&1);i===2?h+=u+=g:h+=g,c[d]=h}}return{columns:n,rows:r,low:t,step:e,whole:c}}function _r({columns:n,rows:t,low:e,step:i,whole:s},r,o){for(let a=0;a<n;a++)o[a]=e[a]+i[a]*s[a*t+r];return o}var nE=48,sE=250,rE=.1,oE=["play","pause","step","speed","seek","reset"];function Z0(){let n=document.getElementById("recording"),t=document.getElementById("recording-data");return!n||!t?null:new af(JSON.parse(n.textContent??""),t.textContent??"")}var af=class{constructor(t,e){this.base="",this.header=t,this.text=e,this.time=0,this.speed=1,this.playing=!0,this.number=0,this.shown=-1,this.layout=-1,this.last=0,this.lastStatus=0,this.parts=[],this.times=new Float64Array(0),this.events=null,this.jumped=()=>{}}async open(t){this.events=t;try{await this.load()}catch(i){t.state("damaged",`This page cannot be shown: ${i instanceof Error?i.message:i}.`);return}t.state("open",""),t.message(this.hello()),this.tellLayout(0),t.message({type:"parameters",parameters:[]}),t.message({type:"presets",presets:[]}),this.tellStatus(),this.last=performance.now();let e=i=>{this.tick(i),requestAnimationFrame(e)};requestAnimationFrame(e)}async load(){let t=X0(this.text);this.text="";let e=0,i=async(l,h)=>{let u=t.slice(e,e+=l.bytes);return q0(l,h,await $0(u))},{parts:s,times:r}=this.header,o=s.reduce((l,h)=>l+h.frames,0),a=await i(r,o);this.times=Float64Array.from(a.whole,l=>r.low[0]+r.step[0]*l);let c=0;for(let l of s){let h={};for(let f of l.streams)h[f.name]=await i(f,l.frames);let{layout:u,good:d}=l;this.parts.push({layout:u,first:c,frames:l.frames,good:d,numbers:h}),c+=l.frames}}hello(){let{ropewalk:t,title:e}=this.header;return{type:"hello",protocol:1,ropewalk:t,client:0,mode:"replay",can:oE,limits:{},title:e,folder:null,address:"",speeds:[.01,4],grabs:0,exports:[]}}send(t){let e=this.header.duration;switch(t.type){case"play":this.time>=e&&this.moveTo(0),this.playing=!0,this.last=performance.now();break;case"pause":this.playing=!1;break;case"step":this.playing=!1,this.time=this.times[Math.min(this.index+(t.count??1),this.times.length-1)];break;case"speed":this.speed=t.value;break;case"seek":this.moveTo(Math.min(Math.max(0,t.time),e));break;case"reset":this.moveTo(0);break}if(this.show(),this.tellStatus(),t.id===void 0)return;let{id:i,type:s}=t;queueMicrotask(()=>this.events?.message({type:"done",id:i,command:s,step:this.index,frame:this.number}))}used(){}moveTo(t){this.time=t,Math.abs(this.index-this.shown)>2&&this.jumped(this.index)}get index(){let[t,e]=[0,this.times.length];for(;e-t>1;){let i=t+e>>1;this.times[i]<=this.time+1e-6?t=i:e=i}return t}tick(t){let e=Math.min(.25,Math.max(0,(t-this.last)/1e3));this.last=t,this.playing&&(this.time=this.later(e*this.speed),this.playing=this.time<this.header.duration,(!this.playing||t-this.lastStatus>sE)&&this.tellStatus()),this.show()}later(t){let{duration:e,single:i}=this.header,{time:s}=this,r=this.times[this.times.length-1-i];if(!i||s+t<r)return Math.min(s+t,e);if(s<r)return r;let o=Math.min(1,(e-r)/(i*rE));return Math.min(s+t*o,e)}show(){let{index:t}=this;if(t===this.shown||!this.events)return;this.shown=t;let e=this.partOf(t);e!==this.layout&&this.tellLayout(e),this.number++,this.events.frame(this.frame(t))}partOf(t){return this.parts.findIndex(({first:e,frames:i})=>t<e+i)}tellLayout(t){this.layout=t,this.events?.message(this.parts[t].layout)}tellStatus(){this.lastStatus=performance.now();let{method:t,dt:e,duration:i}=this.header;this.events?.message({type:"status",playing:this.playing,speed:this.speed,realtime:this.playing?this.speed:0,slow:!1,text:"",time:this.time,step:this.index,dt:e,steps_per_frame:1,method:t,broken:!1,clients:1,address:"",duration:i})}frame(t){let{layout:e,first:i,good:s,numbers:r}=this.parts[this.partOf(t)],o=t-i,[a]=e.variants,{offsets:c,nodes:l,anchors:h}=a,u=new ArrayBuffer(e.bytes),d=new DataView(u,0,nE),f=(this.playing?1:0)|(t===this.times.length-1?16:0)|(o>=s?2:0);[1179670354,e.layout,this.number,f].forEach((N,I)=>d.setUint32(4*I,N,!0)),d.setFloat64(16,this.times[t],!0),d.setFloat64(24,t,!0),d.setFloat32(32,this.playing?this.speed:0,!0),d.setFloat32(36,this.speed,!0);let g=(N,I)=>new Float32Array(u,N,I),y=_r(r.scalars,o,g(c.scalars,e.scalars.length)),m=_r(r.positions,o,g(c.positions,3*l)),p=(N,I)=>{let V=e.scalars.indexOf(N);V>=0&&(y[V]=I)},v=_r(r.tension,o,new Float64Array(r.tension.columns)),[A,S]=Y0(v,new Uint16Array(u,c.tension,l));p("tension_low",A),p("tension_high",S);let C=_r(r.speed,o,new Float64Array(l));p("speed_high",Y0(C,new Uint16Array(u,c.speed,l))[1]);let T=_r(r.velocity,o,new Float32Array(3*h.length)),x=_r(r.force,o,new Float32Array(3*h.length)),E=g(c.anchors,10*h.length);h.forEach(({index:N},I)=>{E.set(m.subarray(3*N,3*N+3),10*I),E.set(T.subarray(3*I,3*I+3),10*I+3),E.set(x.subarray(3*I,3*I+3),10*I+6),E[10*I+9]=1});let k=g(c.grabs,Math.floor((e.bytes-c.grabs)/4));for(let N=0;N<k.length;N+=8)k[N]=-1;return u}};function Y0(n,t){let[e,i]=[0,1e-30];for(let r of n)r<e&&(e=r),r>i&&(i=r);let s=65535/(i-e);for(let r=0;r<n.length;r++)t[r]=(n[r]-e)*s+.5;return[e,i]}var lf=[500,1e3,2e3],aE=1e3,lE=4503,Lh=class{constructor(){this.base="./",this.socket=null,this.tries=0,this.ending="",this.events=null}open(t){this.events=t,this.connect()}connect(){let t=this.events,e=new URL("socket",location.href.split(/[?#]/)[0]);e.protocol=e.protocol.replace("http","ws");let i=new WebSocket(e,"ropewalk.1");i.binaryType="arraybuffer",this.socket=i,setTimeout(()=>{i.readyState===WebSocket.CONNECTING&&t.state("waiting","Setting up the simulation; its first run takes a minute or two …")},aE),i.onopen=()=>t.state("open",""),i.onmessage=({data:s})=>{if(typeof s!="string"){t.frame(s);return}let r=JSON.parse(s);r.type==="hello"&&([this.tries,this.ending]=[0,""]),r.type==="bye"&&(this.ending=r.text),t.message(r)},i.onclose=({code:s,reason:r})=>{if(this.socket!==i)return;let o=this.ending?lf[2]:lf[Math.min(this.tries++,lf.length-1)];(s===1e3||s===1001)&&(this.ending||="The server has ended."),s===lE?t.state("full",r||"As many pages as allowed are open."):this.ending?t.state("ended",this.ending):s===4400||s===4429||s===1009?t.state("lost",`The server closed the connection: ${r||s}.`):t.state("lost","The connection to the server is lost; the run goes on there."),setTimeout(()=>this.connect(),o)}}send(t){this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify(t))}used(t){this.send({type:"ack",frame:t})}};Tl(Em());var cf=Z0(),J0=new Ih(cf??new Lh),cE=document.getElementById("app"),hf=new Il(cE,J0,W0);cf?Pm(hf,cf):Im(hf);Object.assign(window,{ropewalk:Rm(hf)});J0.open();})();
